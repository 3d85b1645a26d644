import { expect, generate, openEmpty, openText, savedSketch, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

/** Two like ladders beside each other: mirrors, and one shifted is the other. */
const LADDERS = {
  format: 'technic-sketch',
  version: 1,
  lines: [0, 6].flatMap((x) => [
    { from: [x, 0, 0], to: [x, 8, 0] },
    { from: [x, 0, 0], to: [x, 0, 4] },
  ]),
};

test('a shift that the program has found is kept by a click', async ({ page }) => {
  await openEmpty(page);
  await openText(page, JSON.stringify(LADDERS));
  await page.getByRole('heading', { name: 'Symmetry' }).click();
  const shift = page.getByRole('checkbox', { name: /^2 lines again, shifted by \(6, 0, 0\)/ });
  await shift.click();
  const { symmetries } = (await savedSketch(page)) as { symmetries?: { kind: string }[] };
  expect(symmetries?.map(({ kind }) => kind)).toEqual(['translation']);
  // Another click lets it go.
  await shift.click();
  expect(await savedSketch(page)).not.toHaveProperty('symmetries');
});

/** Two rafters that meet in their mirror: one layer cannot hold both, so the sides must differ. */
const RAFTERS = {
  format: 'technic-sketch',
  version: 1,
  lines: [
    { from: [-8, 0, 0], to: [0, 0, 6] },
    { from: [8, 0, 0], to: [0, 0, 6] },
    { from: [-8, 0, 0], to: [8, 0, 0] },
  ],
};

test('a mirror that parts cannot keep is said to differ, and where', async ({ page }) => {
  await openEmpty(page);
  await openText(page, JSON.stringify(RAFTERS));
  await page.getByRole('heading', { name: 'Symmetry' }).click();
  await page.getByRole('checkbox', { name: 'Mirror at x = 0' }).click();
  await generate(page);
  const differences = page.getByTestId('differences').getByRole('button');
  await expect(differences).toHaveCount(2);
  await expect(differences.first()).toHaveText(/\(-8, 0, 0\) – \(0, 0, 6\)/);
});
