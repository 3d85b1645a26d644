// One honest verdict: nothing green above something red, and nothing jumps while it is found out.
import type { Page } from '@playwright/test';
import { scaffold } from './helpers/sketches.ts';
import { expect, expectSketch, generate, openEmpty, openText, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

function square(y: number) {
  const corners = [
    [0, y, 0],
    [8, y, 0],
    [8, y, 6],
    [0, y, 6],
  ];
  return corners.map((from, i) => ({ from, to: corners[(i + 1) % 4] }));
}

const sketch = (lines: readonly unknown[]) =>
  JSON.stringify({ format: 'technic-sketch', version: 1, lines });

const card = (page: Page) => page.locator('.verdict-card');

test('lines that only cross are never green, and are mended by a click', async ({ page }) => {
  await openEmpty(page);
  const lines = [
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [3.5, -4, 0], to: [3.5, 4, 0] },
  ];
  await openText(page, sketch(lines));
  await expect(card(page)).toContainText('Something in the drawing to mend');
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(card(page)).toContainText('lines do not meet', { timeout: 60_000 });
  await expect(card(page)).toHaveClass(/\bwarn\b/);
  await page.getByRole('button', { name: 'Move to nodes' }).click();
  await generate(page);
  await expect(card(page)).not.toContainText('do not meet');
  await expectSketch(page, ({ lines }) => Number.isInteger(lines[1]?.from[0]), true);
});

test('lines that nearly touch are named, listed in Check, and joined by a click', async ({
  page,
}) => {
  await openEmpty(page);
  const lines = [
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [3, 0, 0.09], to: [3, 0, 5.09] },
  ];
  await openText(page, sketch(lines));
  await expect(card(page)).toContainText('come within 0.09 modules (0.72 mm)');
  await expect(card(page)).not.toHaveClass(/\bok\b/);
  await page.getByRole('button', { name: /in Check/ }).click();
  const listed = page.getByRole('region', { name: 'Worth a look in the drawing' });
  await expect(listed.getByRole('listitem')).toHaveCount(3);
  await listed.getByRole('button', { name: 'Bring together' }).first().click();
  await expect(listed).toHaveCount(0);
  await expectSketch(page, ({ lines }) => lines[1]?.from, [3, 0, 0]);
});

test('two pieces are never green without a word, and the lesser one is shown', async ({ page }) => {
  await openEmpty(page);
  await openText(page, sketch([...square(0), { from: [0, 9, 0], to: [6, 9, 0] }]));
  await generate(page);
  await expect(card(page)).toContainText('Buildable, but in 2 pieces', { timeout: 60_000 });
  await expect(card(page)).toHaveClass(/\bwarn\b/);
  await page.getByRole('button', { name: 'Show where' }).click();
  await expect(page.locator('.selection-count')).toHaveText('1');
});

test('the panel keeps its places while a search runs', async ({ page }) => {
  await openEmpty(page);
  await openText(page, scaffold(1));
  // The first model brings its verdict, and room for it; from then on nothing moves.
  await generate(page);
  const top = async (name: RegExp) =>
    (await page.getByRole('button', { name }).boundingBox())?.y ?? 0;
  const before = await top(/^Generate/);
  await page.getByRole('button', { name: /^Generate/ }).click();
  const during = await top(/^Cancel|^Generate/);
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 90_000 });
  expect(Math.abs(during - before)).toBeLessThanOrEqual(1);
  await expect.poll(async () => Math.abs((await top(/^Generate/)) - before)).toBeLessThanOrEqual(1);
});
