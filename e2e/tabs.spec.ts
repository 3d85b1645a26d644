// Several tabs of one browser on what it keeps.
import type { BrowserContext, Page } from '@playwright/test';
import { Storm } from './helpers/storm.ts';
import { expect, openEmpty, openText, test, withoutDrawing } from './helpers/test.ts';

test.use({ draws: false });

/** `npm run tabs -- --rounds 200` makes more of them. */
const ROUNDS = Number(process.env['LIFTARM_TAB_ROUNDS'] ?? 3);

const SKETCH = JSON.stringify({
  format: 'technic-sketch',
  version: 1,
  name: 'Shared',
  lines: [
    { from: [0, 0, 0], to: [4, 0, 0] },
    { from: [4, 0, 0], to: [4, 3, 0] },
  ],
});

async function secondTab(context: BrowserContext): Promise<Page> {
  const page = await context.newPage();
  await page.addInitScript(withoutDrawing);
  await page.goto('./');
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Shared');
  return page;
}

async function rename(page: Page, name: string): Promise<void> {
  await page.getByLabel('Name of the sketch').fill(name);
  await page.getByLabel('Name of the sketch').press('Enter');
}

test(`two tabs at once, killed at random: nothing is lost in ${ROUNDS} rounds`, async ({
  context,
}) => {
  test.setTimeout(60_000 + ROUNDS * 30_000);
  const result = await new Storm(context, ROUNDS).run(ROUNDS);
  process.stdout.write(`${JSON.stringify(result)}\n`);
  expect(result.safe).toBeGreaterThan(ROUNDS * 5);
});

test('a tab follows what another one makes of the same sketch', async ({ page, context }) => {
  await openEmpty(page);
  await openText(page, SKETCH);
  await expect(page.locator('html')).toHaveAttribute('data-kept', 'kept');
  const other = await secondTab(context);
  await rename(page, 'Changed here');
  await expect(other.getByLabel('Name of the sketch')).toHaveValue('Changed here');
  await rename(other, 'Changed there');
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Changed there');
  // The history goes along.
  await page.locator('.scene canvas').focus();
  await page.keyboard.press('Control+z');
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Changed here');
  await expect(other.getByLabel('Name of the sketch')).toHaveValue('Changed here');
});

test('a tab whose sketch is deleted in another is told, and keeps it again', async ({
  page,
  context,
}) => {
  await openEmpty(page);
  await openText(page, SKETCH);
  await expect(page.locator('html')).toHaveAttribute('data-kept', 'kept');
  const other = await secondTab(context);
  await openText(other, SKETCH.replace('Shared', 'Second'));
  await expect(other.getByLabel('Name of the sketch')).toHaveValue('Second');
  await other.keyboard.press('Control+k');
  await other.locator('.palette-input').fill('my sketches');
  await other.keyboard.press('Enter');
  await other.getByRole('button', { name: /^Delete Shared/ }).click();
  await other.getByRole('button', { name: /Shared.*(really|for good)|really.*Shared/i }).click();
  await expect(page.getByRole('alert')).toContainText('deleted in another tab');
  await rename(page, 'Again');
  await expect(page.locator('html')).toHaveAttribute('data-kept', 'kept');
  await page.reload();
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Again');
});

test('a browser that keeps nothing says so at once and offers a download', async ({ page }) => {
  await page.addInitScript(() => {
    IDBFactory.prototype.open = () => {
      throw new DOMException('denied', 'SecurityError');
    };
  });
  await page.goto('./');
  const alert = page.getByRole('alert');
  await expect(alert).toContainText('keeps nothing');
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    alert.getByRole('button', { name: 'Download the sketch' }).click(),
  ]);
  expect(file.suggestedFilename()).toMatch(/\.sketch\.json$/);
});

test('a full store says so at once, and keeps what waits when there is room', async ({ page }) => {
  await openEmpty(page);
  await page.evaluate(() => {
    const { put } = IDBObjectStore.prototype;
    Object.assign(globalThis, { full: true });
    IDBObjectStore.prototype.put = function (...args) {
      if ((globalThis as unknown as { full: boolean }).full) {
        throw new DOMException('full', 'QuotaExceededError');
      }
      return put.apply(this, args);
    };
  });
  await openText(page, SKETCH);
  await expect(page.getByRole('alert')).toContainText('could not save');
  await expect(page.locator('html')).toHaveAttribute('data-kept', 'refused');
  await page.evaluate(() => {
    Object.assign(globalThis, { full: false });
  });
  await rename(page, 'Room again');
  await expect(page.locator('html')).toHaveAttribute('data-kept', 'kept');
  await page.reload();
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Room again');
});

test('a page that is left at once keeps its last edit', async ({ page }) => {
  await openEmpty(page);
  await openText(page, SKETCH);
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Shared');
  await rename(page, 'The last word');
  await page.goto('./embed.html');
  await page.goto('./');
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('The last word');
});
