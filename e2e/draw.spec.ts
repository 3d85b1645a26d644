import { nativeCheck } from './helpers/native.ts';
import { scaffold } from './helpers/sketches.ts';
import {
  begun,
  clickPlaces,
  downloaded,
  expect,
  expectLines,
  expectSketch,
  generate,
  openEmpty,
  openText,
  savedSketch,
  test,
} from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

/** Corners of a frame in the view from above, and the first corner again. */
const FRAME = [
  [-200, -150],
  [200, -150],
  [200, 150],
  [-200, 150],
  [-200, -150],
] as const;

test('a frame drawn by hand becomes a model that the command finds buildable', async ({ page }) => {
  await openEmpty(page);
  await page.keyboard.press('l');
  await clickPlaces(page, FRAME);
  await expectLines(page, 4);

  await generate(page);
  await expect(page.getByTestId('verdict')).toContainText('Buildable');

  const model = await downloaded(page, () =>
    page.getByRole('button', { name: 'Model', exact: true }).click(),
  );
  const check = nativeCheck(model);
  expect(check, check.words).toMatchObject({ code: 0 });

  const mpd = await downloaded(page, () => page.getByRole('button', { name: 'LDraw' }).click());
  const { parts } = JSON.parse(model) as { parts: unknown[] };
  // A subassembly is a file of its own, and a row in the file of what it is put on.
  expect(mpd.split('\n').filter((row) => /^1 .*\.dat$/.test(row.trim()))).toHaveLength(
    parts.length,
  );

  const csv = await downloaded(page, () =>
    page.getByRole('button', { name: 'Parts', exact: true }).click(),
  );
  expect(csv.trim().split('\n').length).toBeGreaterThan(1);

  await openText(page, model, 'drawn.model.json');
  await expect(page.getByTestId('verdict')).toContainText('opened from a file and checked');
});

test('undo and redo take every step back and forth, also after a reload', async ({ page }) => {
  await openEmpty(page);
  await page.keyboard.press('l');
  await clickPlaces(page, FRAME);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expectLines(page, 2);

  await page.reload();
  await begun(page);
  await expectLines(page, 2);
  await page.keyboard.press('Control+Shift+z');
  await page.keyboard.press('Control+y');
  await expectLines(page, 4);
  await expect(page.getByRole('button', { name: 'Redo' })).toBeDisabled();
});

test('a typed length and a locked axis decide where a line ends', async ({ page }) => {
  await openEmpty(page);
  await page.keyboard.press('l');
  await clickPlaces(page, [[0, 0]]);
  await page.keyboard.type('x12');
  await page.keyboard.press('Enter');
  await expectSketch(
    page,
    ({ lines }) => lines.map(({ from, to }) => (to[0] ?? 0) - (from[0] ?? 0)),
    [12],
  );
});

test('a selection is moved, copied and deleted', async ({ page }) => {
  await openEmpty(page);
  await page.keyboard.press('r');
  await clickPlaces(page, [
    [-150, -100],
    [150, 100],
  ]);
  await page.keyboard.press('Control+a');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Control+d');
  await expectLines(page, 8);
  await page.keyboard.press('Delete');
  await expectLines(page, 4);
});

test('a search is cancelled at once and the sketch stays', async ({ page }) => {
  await openEmpty(page);
  await openText(page, scaffold(8));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Scaffold');
  const { lines } = await savedSketch(page);
  await page.getByRole('button', { name: /^Generate/ }).click();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(page.getByText(/^Cancelled/)).toBeVisible();
  await expectLines(page, lines.length);
});
