import { expect, expectLines, generate, goTo, openEmpty, openText, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

/** Four pins and no diagonal: it folds. */
const SQUARE = {
  format: 'technic-sketch',
  version: 1,
  lines: [
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [8, 0, 0], to: [8, 0, 6] },
    { from: [8, 0, 6], to: [0, 0, 6] },
    { from: [0, 0, 6], to: [0, 0, 0] },
  ],
};

test('the line that is offered for a loose frame is added by a click and makes it rigid', async ({
  page,
}) => {
  await openEmpty(page, { preset: 'simple' });
  await openText(page, JSON.stringify(SQUARE));
  await generate(page);
  await goTo(page, 'Check');
  const freedoms = page.locator('.check-view').filter({ hasText: 'Rigidity' });
  await expect(freedoms).toContainText('1 without friction');
  await freedoms.locator('summary').click();
  await freedoms.getByRole('button', { name: /^Add a line of \d+ modules$/ }).click();
  await expectLines(page, 5);
  await generate(page);
  await expect(freedoms).toContainText('rigid');
});
