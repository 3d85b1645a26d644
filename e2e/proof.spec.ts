import { expect, expectLines, generate, goTo, openEmpty, openText, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

/** A square of 4 x 4: bent beams and axles may cover it, so its quick bound lies below what any model has. */
const SQUARE = {
  format: 'technic-sketch',
  version: 1,
  lines: [
    { from: [0, 0, 0], to: [4, 0, 0] },
    { from: [4, 0, 0], to: [4, 4, 0] },
    { from: [4, 4, 0], to: [0, 4, 0] },
    { from: [0, 4, 0], to: [0, 0, 0] },
  ],
};

test('a click proves how few beams do, and what the bound proves needs no click', async ({
  page,
}) => {
  await openEmpty(page);
  await openText(page, JSON.stringify(SQUARE));
  await generate(page);
  await goTo(page, 'Check');
  const proof = page.locator('.check-view').filter({ hasText: 'Fewest beams' });
  await proof.locator('summary').click();
  await expect(proof.getByTestId('proof')).toContainText(/at least \d+ are needed/);
  await proof.getByRole('button', { name: 'Prove it' }).click();
  await expect(proof.getByTestId('proof')).toContainText('Nobody has proved more', {
    timeout: 30_000,
  });
  await goTo(page, 'Draw');
  await openText(page, JSON.stringify({ ...SQUARE, lines: [{ from: [0, 0, 0], to: [8, 0, 0] }] }));
  // Files are read in a worker: the drawing comes a moment later.
  await expectLines(page, 1);
  await generate(page);
  await goTo(page, 'Check');
  await expect(proof).toContainText('proved');
});
