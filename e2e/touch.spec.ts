// Parts of the model are taken hold of: locked, forbidden, swapped, pulled to another layer, coloured, deleted.
import type { Locator, Page } from '@playwright/test';
import type { Keep } from '../web/src/model/keep.ts';
import type { SketchDocument } from '../web/src/model/sketch.ts';
import { decodeShare } from '../web/src/share/codec.ts';
import { linkOf } from './helpers/links.ts';
import { expect, openPage, savedSketch, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

const SOLVED = { timeout: 60_000 };

/** A portal with a brace. */
const PORTAL: SketchDocument = {
  format: 'technic-sketch',
  version: 1,
  name: 'Portal',
  lines: [
    { from: [0, 0, 0], to: [0, 0, 8] },
    { from: [8, 0, 0], to: [8, 0, 8] },
    { from: [0, 0, 8], to: [8, 0, 8] },
    { from: [0, 0, 5], to: [4, 0, 8] },
    { from: [0, 0, 0], to: [8, 0, 0] },
  ],
};

async function open(page: Page): Promise<Locator> {
  await openPage(page, `/${await linkOf(PORTAL)}`);
  await expect(page.getByTestId('verdict')).toContainText('Buildable', SOLVED);
  await page.locator('.scene canvas').focus();
  await page.keyboard.press('n');
  const card = page.getByRole('region', { name: 'Part', exact: true });
  await expect(card.getByRole('button', { name: 'Lock', exact: true })).toBeVisible(SOLVED);
  return card;
}

async function keep(page: Page): Promise<readonly Keep[] | undefined> {
  return ((await savedSketch(page)) as unknown as SketchDocument).keep;
}

test('a locked part stays picked and has a padlock; undo takes it away', async ({ page }) => {
  const card = await open(page);
  await card.getByRole('button', { name: 'Lock', exact: true }).click();
  await expect(card.getByRole('button', { name: 'Unlock' })).toHaveAttribute(
    'aria-pressed',
    'true',
    SOLVED,
  );
  await expect(page.locator('.scene-locks > span')).toHaveCount(1);
  await expect(page.getByTestId('verdict')).toContainText('Buildable', SOLVED);
  expect((await keep(page))?.flatMap(({ parts = [] }) => parts)).toHaveLength(1);
  await page.keyboard.press('Control+z');
  await expect(page.locator('.scene-locks > span')).toHaveCount(0);
  expect(await keep(page)).toBeUndefined();
});

test('a link carries what is locked', async ({ page }) => {
  const card = await open(page);
  await card.getByRole('button', { name: 'Lock', exact: true }).click();
  await expect(page.locator('.scene-locks > span')).toHaveCount(1);
  const kept = await keep(page);
  const held = async () => {
    const read = await decodeShare(new URL(page.url()).hash.slice(1));
    return read?.ok ? read.value.sketch.keep : null;
  };
  await expect.poll(held).toEqual(kept);
});

test('a forbidden part lies elsewhere, and the model is buildable', async ({ page }) => {
  const card = await open(page);
  await card.getByRole('button', { name: 'Forbid here' }).click();
  await expect(page.getByTestId('grown')).toBeVisible(SOLVED);
  await expect(page.getByTestId('verdict')).toContainText('Buildable', SOLVED);
  expect((await keep(page))?.flatMap(({ barred = [] }) => barred)).toHaveLength(1);
});

test('what also fits is listed with what it changes, and is locked when it is taken', async ({
  page,
}) => {
  const card = await open(page);
  await card.getByRole('button', { name: 'Swap' }).click();
  const list = card.getByRole('region', { name: 'What else fits here' });
  await expect(list).toHaveAttribute('aria-busy', 'false', SOLVED);
  const first = list.getByRole('listitem').first().getByRole('button');
  const name = await first.getByRole('strong').textContent();
  await first.click();
  await expect(card.getByRole('button', { name: 'Unlock' })).toBeVisible(SOLVED);
  await expect(card.getByRole('heading', { level: 3 })).toHaveText(name ?? '');
  await expect(page.getByTestId('verdict')).toContainText('Buildable', SOLVED);
});

test('a part is pulled to another layer', async ({ page }) => {
  const card = await open(page);
  const other = card.getByRole('button', { name: 'To layer', pressed: false }).first();
  const layer = Number((await other.textContent())?.replace('−', '-'));
  await other.click();
  await expect(card.getByRole('button', { name: 'Unlock' })).toBeVisible(SOLVED);
  expect((await keep(page))?.flatMap(({ parts = [] }) => parts.map((part) => part.layer))).toEqual([
    layer,
  ]);
});

test('a part gets a colour of its own and gives it back', async ({ page }) => {
  const card = await open(page);
  await card.getByRole('button', { name: /: Green$/ }).click();
  await expect(card.getByRole('button', { name: 'as the rest' })).toBeVisible(SOLVED);
  await expect(card.getByRole('definition').nth(1)).toHaveText('Green');
  await card.getByRole('button', { name: 'as the rest' }).click();
  await expect(card.getByRole('button', { name: 'as the rest' })).toHaveCount(0, SOLVED);
});

test('a deleted part takes its stretch of the drawing with it', async ({ page }) => {
  const card = await open(page);
  await card.getByRole('button', { name: 'Delete' }).click();
  await expect(card).toHaveCount(0, SOLVED);
  await expect(page.getByTestId('verdict')).toContainText('Buildable', SOLVED);
  expect((await savedSketch(page)).lines).not.toEqual(PORTAL.lines);
});

test('a line has a side, ends of beams, and beams to take hold of', async ({ page }) => {
  await open(page);
  await page.keyboard.press('Escape');
  await page.keyboard.press('.');
  const card = page.getByRole('region', { name: /^Line \d, \d modules$/ });
  await expect(card).toBeVisible();
  const side = card.getByRole('radio', { name: 'on the line' });
  await side.click();
  await expect(side).toBeChecked();
  await expect(page.getByTestId('grown')).toBeVisible(SOLVED);
  expect((await keep(page))?.map(({ layers }) => layers)).toEqual([[0]]);
  await card.getByRole('button', { name: 'Split here' }).click();
  await expect(card.getByRole('button', { name: /^No split at hole/ })).toBeVisible();
  const beam = card.getByRole('group', { name: 'Beams on it' }).getByRole('button').first();
  await beam.click(SOLVED);
  await expect(page.getByRole('region', { name: 'Part', exact: true })).toBeVisible();
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 } });

  test('the card does not hide the part that it is about, nor its padlock', async ({ page }) => {
    const card = await open(page);
    const lock = page.locator('.scene-locks > span');
    // One part after the other, so that some lie where the card is.
    for (let i = 0; i < 6; i++) {
      await page.locator('.scene canvas').focus();
      await page.keyboard.press('n');
      const keepIt = card.getByRole('button', { name: 'Lock', exact: true });
      if (!(await keepIt.isVisible())) {
        continue;
      }
      await keepIt.click();
      await expect(card.getByRole('button', { name: 'Unlock' })).toBeVisible(SOLVED);
      await expect(lock).toHaveCount(1);
      const [mark, sheet] = [await lock.boundingBox(), await card.boundingBox()];
      expect((mark?.y ?? 0) + (mark?.height ?? 0)).toBeLessThan(sheet?.y ?? 0);
      await card.getByRole('button', { name: 'Unlock' }).click();
      await expect(lock).toHaveCount(0);
      await expect(keepIt).toBeVisible(SOLVED);
    }
  });
});
