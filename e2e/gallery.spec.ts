import { expect, test } from './helpers/test.ts';

test.describe('without looking at the drawing', () => {
  test.use({ draws: false });

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
    await page.getByRole('button', { name: 'Open with its gears' }).click();
    const result = page.getByRole('complementary');
    await expect(result.getByText('opened from a file and checked')).toBeVisible();
    await expect(result.getByTestId('verdict')).toContainText('Buildable');
  });
});

test('joints of a moving model turn in the gallery, within their range', async ({ page }) => {
  await page.goto('./?room=gallery');
  const seesaw = page.locator('[data-model="seesaw"]');
  await seesaw.getByRole('button', { name: 'Move it' }).click();
  const angle = page.getByRole('slider', { name: 'Angle' });
  await expect(angle).toBeVisible({ timeout: 90_000 });
  const picture = page.locator('.moving-picture canvas');
  const before = await picture.screenshot();
  const most = Number(await angle.getAttribute('max'));
  expect(most).toBeGreaterThan(5);
  await angle.press('End');
  expect(Math.abs(Number(await angle.inputValue()) - most)).toBeLessThan(0.5);
  expect((await picture.screenshot()).equals(before)).toBe(false);
  await page.getByRole('button', { name: 'Back to the gallery' }).click();
  await expect(page.locator('.gallery-card')).toHaveCount(26);
});
