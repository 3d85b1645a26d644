import { expect, test } from './helpers/test.ts';

test('the gallery has pictures and figures, and opens its models', async ({ page }) => {
  await page.goto('./?room=gallery');
  const cards = page.locator('.gallery-card');
  await expect(cards).toHaveCount(26);
  await expect(page.locator('.gallery-badge').nth(8)).toBeAttached();
  const first = cards.first().locator('img');
  await expect
    .poll(() => first.evaluate((image: HTMLImageElement) => image.naturalWidth))
    .toBe(320);
  await page.locator('[data-model="seesaw"] .gallery-open').click();
  await expect(page.locator('.room')).toHaveCount(0);
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Seesaw');
});

test('gears turn with the right ratio', async ({ page }) => {
  await page.goto('./?room=gallery');
  await page
    .locator('[data-model="gear-box"]')
    .getByRole('button', { name: 'See the gears turn' })
    .click();
  await expect(page.getByTestId('ratio')).toContainText('15 turns', { timeout: 90_000 });
  await page.getByLabel('Crank').fill('7.5');
  const shafts = page.locator('.gear-shafts li');
  await expect(shafts.nth(0)).toHaveAttribute('data-turns', '7.5000');
  await expect(shafts.nth(1)).toHaveAttribute('data-turns', '-2.5000');
  await expect(shafts.nth(2)).toHaveAttribute('data-turns', '0.5000');
});
