import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { expect, openPage, runCommand, test } from './helpers/test.ts';

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
      ['Shift+S', 'My sketches'],
    ] as const) {
      await page.locator('.scene canvas').focus();
      await page.keyboard.press(shortcut);
      await expect(page.getByRole('dialog', { name })).toBeVisible();
      expect(await seriousFindings(page)).toEqual([]);
      await page.keyboard.press('Escape');
      await expect(page.getByRole('dialog')).toBeHidden();
    }
    await runCommand(page, 'brick set');
    await expect(page.getByRole('dialog', { name: 'Brick set' })).toBeVisible();
    expect(await seriousFindings(page)).toEqual([]);
    await page.keyboard.press('Escape');
    for (const flyout of ['Look inside', 'Standard views']) {
      await page.locator(`summary[aria-label^="${flyout}"]`).click();
      expect(await seriousFindings(page)).toEqual([]);
      await page.keyboard.press('Escape');
    }
  });
}

for (const room of ['instructions', 'share', 'gallery', 'lessons']) {
  test(`axe finds nothing serious in the room ${room}`, async ({ page }) => {
    await page.goto(`/?room=${room}`);
    await expect(page.locator('.room-body > *').first()).toBeVisible();
    await expect(page.getByText('Loading…')).toBeHidden();
    expect(await seriousFindings(page)).toEqual([]);
    await page.getByRole('button', { name: 'Back to the drawing' }).click();
    await expect(page.locator('.room')).toBeHidden();
  });
}

test('the page speaks German to those who ask for it', async ({ page }) => {
  await page.goto('/?lang=de#s2.broken.0');
  await expect(page.getByRole('button', { name: 'Rückgängig' })).toBeVisible();
  await expect(page.locator('html')).toHaveAttribute('lang', 'de');
  await expect(page.getByRole('alert')).toContainText('Dieser Link ist beschädigt');
  await expect(page.getByText('Jedes Teil gibt es')).toBeAttached({ timeout: 60_000 });
  await page.keyboard.press('Control+k');
  await page.locator('.palette-input').fill('sprache english');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('button', { name: 'Undo' })).toBeVisible();
});

test('every command can be reached from the keyboard', async ({ page }) => {
  await openPage(page);
  // Which commands there are changes when a search ends: wait for that first.
  await expect(page.getByTestId('verdict')).toBeAttached({ timeout: 90_000 });
  await page.keyboard.press('Control+k');
  const shown = await page.getByRole('option').count();
  expect(shown).toBeGreaterThan(60);
  await page.keyboard.press('ArrowUp');
  await expect(page.getByRole('option').last()).toHaveAttribute('aria-selected', 'true');
});
