// What moves: played, several joints at once.
import type { Page } from '@playwright/test';
import { expect, openEmpty, openText, test } from './helpers/test.ts';

test.use({ draws: false });

/** A rail with an arm at either end. */
const ARMS = JSON.stringify({
  format: 'technic-sketch',
  version: 1,
  name: 'Two arms',
  lines: [
    { from: [0, 0, 0], to: [10, 0, 0] },
    { from: [0, 0, 0], to: [0, 6, 0] },
    { from: [10, 0, 0], to: [10, 6, 0] },
  ],
  joints: [
    { at: [0, 0, 0], axis: [0, 0, 1] },
    { at: [10, 0, 0], axis: [0, 0, 1] },
  ],
});

async function openMoving(page: Page): Promise<void> {
  await openEmpty(page);
  await openText(page, ARMS);
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 90_000 });
  await page.getByRole('link', { name: 'Move', exact: true }).click();
  await expect(page.getByRole('slider', { name: 'Angle' })).toBeVisible({ timeout: 90_000 });
}

/** Plays until what stands on a slider has changed, then stops it. */
async function playsOn(page: Page, name: string): Promise<void> {
  const angle = page.getByRole('slider', { name });
  const before = await angle.inputValue();
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await expect(angle).not.toHaveValue(before);
  await page.getByRole('button', { name: 'Pause', exact: true }).click();
}

test('two joints move at once', async ({ page }) => {
  await openMoving(page);
  await page.getByRole('checkbox', { name: /Joint 2/ }).check();
  const sliders = page.locator('.motion-player').getByRole('slider');
  await expect(sliders).toHaveCount(2);
  await playsOn(page, 'Angle, Joint 1');
  await expect(page.getByRole('slider', { name: 'Angle, Joint 2' })).not.toHaveValue('0');
  await page.getByRole('checkbox', { name: /Joint 2/ }).uncheck();
  await expect(sliders).toHaveCount(1);
});
