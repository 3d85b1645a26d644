// What is drawn by numbers: lengths changed in their place, lines moved, copied and mirrored by typed offsets.
import type { Page } from '@playwright/test';
import { expect, expectSketch, openEmpty, openText, type Saved, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

/** A frame of 8 by 6, lying down. */
const FRAME = JSON.stringify({
  format: 'technic-sketch',
  version: 1,
  name: 'Frame',
  lines: [
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [8, 0, 0], to: [8, 6, 0] },
    { from: [8, 6, 0], to: [0, 6, 0] },
    { from: [0, 6, 0], to: [0, 0, 0] },
  ],
});

async function openFrame(page: Page): Promise<void> {
  await openEmpty(page);
  await openText(page, FRAME);
  await expectSketch(page, ({ lines }) => lines.length, 4);
  await page.locator('.scene canvas').focus();
  await page.keyboard.press('.');
}

const corners = ({ lines }: Saved) => lines.map(({ from }) => from.join(' '));

test('a length typed in its place moves the side that the arrow says', async ({ page }) => {
  await openFrame(page);
  const length = page.getByRole('textbox', { name: 'Length of line 1' });
  await expect(length).toHaveValue('8');
  await page.getByRole('button', { name: 'Moves the end at (8, 0, 0); click for' }).click();
  await expect(page.getByRole('button', { name: 'Moves the end at (0, 0, 0)' })).toBeVisible();
  await length.fill('11');
  await length.press('Enter');
  await expectSketch(page, corners, ['-3 0 0', '8 0 0', '8 6 0', '-3 6 0']);
  await expect(page.locator('.scene canvas')).toBeFocused();
  await page.keyboard.press('Control+z');
  await expectSketch(page, corners, ['0 0 0', '8 0 0', '8 6 0', '0 6 0']);
});

test('a digit over the drawing begins the length of the selected line', async ({ page }) => {
  await openFrame(page);
  await page.keyboard.press('1');
  await page.keyboard.press('2');
  await page.keyboard.press('Enter');
  await expectSketch(page, corners, ['0 0 0', '12 0 0', '12 6 0', '0 6 0']);
});

test('a length that cannot be is refused in words, and Escape brings the old one back', async ({
  page,
}) => {
  await openFrame(page);
  const length = page.getByRole('textbox', { name: 'Length of line 1' });
  await length.fill('0');
  await length.press('Enter');
  await expect(
    page.getByRole('alert').filter({ hasText: 'A length is a whole number' }),
  ).toBeVisible();
  await length.press('Escape');
  await expect(length).toHaveValue('8');
  await expectSketch(page, corners, ['0 0 0', '8 0 0', '8 6 0', '0 6 0']);
});

test('lengths stand beside all lines when that is wanted', async ({ page }) => {
  await openFrame(page);
  await page.keyboard.press('Escape');
  await expect(page.locator('.dimension')).toHaveCount(0);
  await page.keyboard.press('Shift+L');
  await expect(page.locator('.dimension')).toHaveText(['8', '6', '8', '6']);
});

test('lines are moved, copied and mirrored by numbers', async ({ page }) => {
  await openFrame(page);
  await page.keyboard.press('Control+a');
  await page.getByRole('button', { name: 'Move, copy or mirror by numbers…' }).click();
  const card = page.getByRole('region', { name: 'By numbers' });
  const field = (name: string) => card.getByRole('spinbutton', { name, exact: true });
  await expect(card.getByRole('button', { name: 'Move', exact: true })).toBeDisabled();
  await field('X').fill('2');
  await field('Z').fill('-3');
  await field('Z').press('Enter');
  await expectSketch(page, corners, ['2 0 -3', '10 0 -3', '10 6 -3', '2 6 -3']);

  await card.getByRole('radio', { name: 'Copies' }).click();
  await field('X').fill('0');
  await field('Z').fill('5');
  await field('How many copies').fill('2');
  await card.getByRole('button', { name: 'Copy', exact: true }).click();
  await expectSketch(page, ({ lines }) => lines.map(({ from }) => from[2]), [
    ...[-3, -3, -3, -3],
    ...[2, 2, 2, 2],
    ...[7, 7, 7, 7],
  ]);

  // What is undone leaves what there is of it selected, and the card where it is.
  await page.keyboard.press('Control+z');
  await expect(card).toHaveCount(1);
  await page.keyboard.press('Control+a');
  await card.getByRole('radio', { name: 'Mirror' }).click();
  await field('X =').fill('10.5');
  await card.getByRole('button', { name: 'Mirror', exact: true }).click();
  await expectSketch(
    page,
    ({ lines }) => lines.slice(4).map(({ from }) => from[0]),
    [19, 11, 11, 19],
  );
});

test('a box is typed, without a click', async ({ page }) => {
  await openEmpty(page);
  await page.keyboard.press('b');
  await page.keyboard.type('6,8,4');
  await page.keyboard.press('Enter');
  await expectSketch(page, ({ lines }) => lines.length, 12);
});
