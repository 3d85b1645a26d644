// Makes the pictures of docs/pictures/: `npm run screenshots`. Left out of the ordinary run.
import { resolve } from 'node:path';
import type { Page } from '@playwright/test';
import { scaffold } from './helpers/sketches.ts';
import {
  canvasPoint,
  chooseExample,
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
  await chooseExample(page, name);
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
  await openText(page, scaffold(14));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Scaffold');
  await page.keyboard.press('i');
  await settled(page);
  await page.getByRole('button', { name: /^Generate/ }).click();
  // Long enough under way for a model and a course of the search.
  await expect(page.locator('.progress .chart')).toBeVisible({ timeout: 100_000 });
  await settled(page);
  await page.screenshot({ path: resolve(FOLDER, 'solving.png') });
  await expect(page.getByRole('progressbar')).toBeVisible();
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
  await page.keyboard.press('Shift+E');
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
  // A brick, by the keyboard: where it lies on screen is the search's affair.
  await page.locator('.scene canvas').focus();
  await page.keyboard.press('n');
  await shoot(page, 'look-inside');
});

test('sketches and bricks', async ({ page }) => {
  await openExample(page, /^House/);
  await chooseExample(page, /^Seesaw/);
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
  await openEmpty(page);
  await page.keyboard.press('o');
  // Large enough for a search with a course.
  await openText(page, scaffold(3));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Scaffold');
  await page.keyboard.press('i');
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 100_000 });
  await page.getByRole('heading', { name: 'Parts' }).click();
  await page.getByRole('heading', { name: 'Search' }).click();
  await page.getByRole('heading', { name: 'Symmetry' }).click();
  await page
    .getByRole('checkbox', { name: /^Mirror at x/ })
    .first()
    .hover();
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
  // Where the lines of this frame meet no part may be: no beam can go round it.
  const sketch = {
    format: 'technic-sketch',
    version: 1,
    name: 'Frame through a wall',
    lines: [
      { from: [0, 0, 0], to: [10, 0, 0] },
      { from: [0, 0, 6], to: [10, 0, 6] },
      { from: [0, 0, 0], to: [0, 0, 6] },
      { from: [10, 0, 0], to: [10, 0, 6] },
    ],
    keepOut: [{ min: [4, -3, 3], max: [5, 3, 9] }],
  };
  await page.keyboard.press('o');
  await page.keyboard.press('i');
  await openText(page, JSON.stringify(sketch));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Frame through a wall');
  await page.keyboard.press('i');
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByTestId('verdict')).toContainText('Not buildable', { timeout: 100_000 });
  await page.keyboard.press('f');
  await shoot(page, 'failed');
});

test('fault', async ({ page }) => {
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
  await shoot(page, 'fault');
});

test('instructions', async ({ page }) => {
  await openExample(page, /^Chair/);
  await runCommand(page, 'building instructions');
  await expect(page.getByRole('img', { name: 'Picture of the step' })).toBeVisible();
  for (let i = 0; i < 6; i++) {
    await page.keyboard.press('ArrowRight');
  }
  await shoot(page, 'instructions');
});

test('gallery and lessons', async ({ page }) => {
  await page.goto('./?room=gallery');
  await expect(page.locator('.gallery-card img').first()).toBeVisible();
  await page.waitForLoadState('networkidle');
  await shoot(page, 'gallery');
  await page.goto('./?room=lessons&lesson=annealing');
  await expect(page.locator('[data-lesson] svg').first()).toBeVisible();
  await shoot(page, 'lesson');
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
    await page.getByRole('button', { name: 'Hide result and settings' }).tap();
    await runCommand(page, 'building instructions');
    await expect(page.getByRole('img', { name: 'Picture of the step' })).toBeVisible();
    await shoot(page, 'phone-instructions');
  });
});
