// What a person owns is obeyed like an edit: at once, without a press of Generate.
import { linkOf } from './helpers/links.ts';
import { expect, openPage, runCommand, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

const SOLVED = { timeout: 60_000 };

test('a part that is not owned is not built with, a moment after that is said', async ({
  page,
}) => {
  const frame = await linkOf({
    format: 'technic-sketch',
    version: 1,
    name: 'Frame',
    lines: [
      { from: [0, 0, 0], to: [0, 0, 8] },
      { from: [8, 0, 0], to: [8, 0, 8] },
      { from: [0, 0, 8], to: [8, 0, 8] },
      { from: [0, 0, 0], to: [8, 0, 0] },
    ],
  });
  await openPage(page, `/${frame}`);
  await expect(page.getByTestId('verdict')).toContainText('Buildable', SOLVED);
  const nines = page.getByRole('button', { name: /^Beam 9 40490/ });
  await expect(nines).toBeVisible();
  await runCommand(page, 'Brick set');
  const owned = page.getByRole('spinbutton', { name: 'How many of Beam 9 there are' });
  await owned.fill('0');
  await owned.press('Tab');
  await page.keyboard.press('Escape');
  await expect(nines).toHaveCount(0, SOLVED);
  await expect(page.getByTestId('verdict')).toContainText('Buildable', SOLVED);
  await expect(page.getByTestId('verdict')).not.toContainText(/missing/i);
});
