import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { expect, openPage, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

async function seriousFindings(page: Page): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page }).analyze();
  return violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(' ')}`);
}

for (const theme of ['light', 'dark'] as const) {
  test(`axe finds nothing serious on any sheet (${theme})`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: theme, reducedMotion: 'reduce' });
    await openPage(page);
    await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
    await page.getByRole('heading', { name: 'Settings' }).click();
    expect(await seriousFindings(page)).toEqual([]);
    for (const [shortcut, name] of [
      ['Control+k', 'All commands'],
      ['?', 'Keys and help'],
      ['Shift+E', 'Examples'],
    ] as const) {
      await page.locator('.scene canvas').focus();
      await page.keyboard.press(shortcut);
      await expect(page.getByRole('dialog', { name })).toBeVisible();
      expect(await seriousFindings(page)).toEqual([]);
      await page.keyboard.press('Escape');
      await expect(page.getByRole('dialog')).toBeHidden();
    }
  });
}
