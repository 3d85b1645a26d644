import type { Page } from '@playwright/test';
import { expect, steadyBox, test } from './helpers/test.ts';

test.use({ draws: false });

const said = (page: Page) => page.getByTestId('linkage-said');
const cards = (page: Page) => page.locator('.linkage-card');

test('a drawn path becomes a machine that turns', async ({ page }) => {
  await page.goto('./?room=linkage');
  const paper = page.locator('.path-canvas');
  const box = await steadyBox(paper);
  // An ellipse of about 8 by 4 modules; 20 modules are as high as the paper.
  const unit = box.height / 20;
  const at = (i: number) =>
    [
      box.x + box.width / 2 + 4 * unit * Math.cos(i / 10),
      box.y + box.height / 2 - 2 * unit * Math.sin(i / 10),
    ] as const;
  await page.mouse.move(...at(0));
  await page.mouse.down();
  for (let i = 1; i <= 62; i++) {
    await page.mouse.move(...at(i));
  }
  await page.mouse.up();
  await expect(cards(page)).toHaveCount(6, { timeout: 90_000 });
  await expect(page.getByLabel('Closed')).toBeChecked();
  await expect(said(page)).toContainText('6 machines');
  await cards(page).first().click();
  await expect(page.getByLabel('Name of the sketch')).toHaveValue(/^Four-bar/);
  await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 90_000 });
  await page.getByRole('link', { name: 'Move' }).click();
  await expect(page.getByText('all the way round').first()).toBeVisible({ timeout: 90_000 });
});

test('a machine can be had without drawing by hand', async ({ page }) => {
  await page.goto('./?room=linkage');
  const room = page.locator('.linkages');
  await room.getByRole('button', { name: 'Foot', exact: true }).press('Enter');
  await expect(cards(page)).toHaveCount(6, { timeout: 90_000 });
  await room.getByRole('button', { name: 'Line', exact: true }).press('Enter');
  await expect(cards(page).first()).toContainText('0.0');
});
