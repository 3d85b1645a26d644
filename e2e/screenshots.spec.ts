// Makes the pictures of docs/pictures/: `npm run screenshots`. Left out of the ordinary run.
import { resolve } from 'node:path';
import type { Page } from '@playwright/test';
import { scaffold } from './helpers/sketches.ts';
import {
  canvasPoint,
  clickPlaces,
  expect,
  openEmpty,
  openPage,
  openText,
  runCommand,
  settled,
  test,
} from './helpers/test.ts';

const FOLDER = resolve(import.meta.dirname, '../docs/pictures');

test.skip(process.env['LIFTARM_SCREENSHOTS'] === undefined, 'only on request');

async function shoot(page: Page, name: string): Promise<void> {
  await settled(page);
  await page.screenshot({ path: resolve(FOLDER, `${name}.png`) });
}

async function openExample(page: Page, name: RegExp): Promise<void> {
  await openPage(page);
  await page.getByRole('button', { name: 'Examples', exact: true }).click();
  await page.getByRole('button', { name }).click();
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 100_000 });
  await settled(page);
}

test('start', async ({ page }) => {
  await openPage(page);
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 100_000 });
  await shoot(page, 'start');
});

test('empty', async ({ page }) => {
  await openEmpty(page);
  await page.keyboard.press('i');
  await shoot(page, 'empty');
});

test('drawing', async ({ page }) => {
  await openEmpty(page);
  await page.keyboard.press('o');
  await page.keyboard.press('i');
  await page.keyboard.press('b');
  await settled(page);
  await clickPlaces(page, [
    [-230, 10],
    [200, 20],
  ]);
  for (let i = 0; i < 5; i++) {
    await page.keyboard.press('PageUp');
  }
  await page.keyboard.press('Enter');
  await page.keyboard.press('l');
  await clickPlaces(page, [[-40, -120]]);
  await page.mouse.move(760, 440);
  await shoot(page, 'drawing');
});

test('solving', async ({ page }) => {
  test.setTimeout(300_000);
  await openEmpty(page);
  await page.keyboard.press('o');
  await page.keyboard.press('i');
  await openText(page, scaffold(4));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Scaffold');
  await settled(page);
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByRole('progressbar')).toBeVisible();
  await expect(page.getByText(/\d steps/)).toBeVisible({ timeout: 200_000 });
  await page.screenshot({ path: resolve(FOLDER, 'solving.png') });
});

test('airplane', async ({ page }) => {
  await openExample(page, /^Small airplane/);
  await shoot(page, 'airplane');
});

test('dark', async ({ page }) => {
  await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
  await openExample(page, /^House/);
  await shoot(page, 'dark');
});

test('examples and help', async ({ page }) => {
  await openPage(page);
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 100_000 });
  await page.getByRole('button', { name: 'Examples', exact: true }).click();
  await expect(page.getByRole('button', { name: /^House/ })).toBeVisible();
  await shoot(page, 'examples');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+k');
  await shoot(page, 'palette');
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Keys and help' }).click();
  await shoot(page, 'help');
});

test('look inside', async ({ page }) => {
  await openExample(page, /^Chair/);
  await runCommand(page, 'cut open along Y');
  const brick = await canvasPoint(page, 30, -220);
  await page.mouse.click(brick.x, brick.y);
  await shoot(page, 'look-inside');
});

test('sketches and bricks', async ({ page }) => {
  await openExample(page, /^House/);
  await page.getByRole('button', { name: 'Examples', exact: true }).click();
  await page.getByRole('button', { name: /^Seesaw/ }).click();
  await page.keyboard.press('Control+a');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Shift+S');
  await expect(page.locator('.sketch-card').first()).toBeVisible();
  await shoot(page, 'sketches');
  await page.keyboard.press('Escape');
  await runCommand(page, 'brick set');
  await expect(page.locator('.part-picture img').nth(8)).toBeVisible({ timeout: 60_000 });
  await shoot(page, 'bricks');
});

test('settings and search', async ({ page }) => {
  await openExample(page, /^Table/);
  await page.getByRole('heading', { name: 'Parts' }).click();
  await page.getByRole('heading', { name: 'Search' }).click();
  await page.getByRole('heading', { name: 'Symmetry' }).click();
  await page.getByRole('checkbox', { name: /^Mirror at x/ }).hover();
  await shoot(page, 'search');
  await page.getByRole('heading', { name: 'Settings' }).click();
  await page.getByRole('heading', { name: 'Settings' }).scrollIntoViewIfNeeded();
  await page.mouse.wheel(0, 2000);
  await shoot(page, 'settings');
});

test('snaps', async ({ page }) => {
  await openEmpty(page);
  await page.keyboard.press('l');
  await clickPlaces(page, [
    [-200, -100],
    [0, -100],
  ]);
  const end = await canvasPoint(page, 150, 100);
  await page.mouse.move(end.x, end.y);
  await shoot(page, 'snap');
});

test('German', async ({ page }) => {
  await page.goto('/?lang=de');
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 100_000 });
  await shoot(page, 'german');
});

test('failed', async ({ page }) => {
  await openEmpty(page);
  // Two lines cross between their nodes: no pin can join them there.
  const sketch = {
    format: 'technic-sketch',
    version: 1,
    name: 'Crossing between nodes',
    lines: [
      { from: [0, 0, 0], to: [8, 0, 0] },
      { from: [3.5, -4, 0], to: [3.5, 4, 0] },
      { from: [0, 0, 0], to: [0, 0, 5] },
    ],
  };
  await page.keyboard.press('o');
  await page.keyboard.press('i');
  await openText(page, JSON.stringify(sketch));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Crossing between nodes');
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByTestId('verdict').or(page.getByRole('alert'))).toBeVisible({
    timeout: 100_000,
  });
  await shoot(page, 'failed');
});

test.describe('projector', () => {
  test.use({ viewport: { width: 1920, height: 1080 } });

  test('projector', async ({ page }) => {
    await openExample(page, /^Truss bridge/);
    await shoot(page, 'projector');
  });
});

test.describe('phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('phone', async ({ page }) => {
    await openPage(page);
    await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 100_000 });
    await shoot(page, 'phone');
    await page.getByRole('button', { name: 'Show result and settings' }).tap();
    await shoot(page, 'phone-result');
  });
});
