import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import type { Locator, Page } from '@playwright/test';
import { linkOf, publicSketch } from './helpers/links.ts';
import { expect, steadyBox, test } from './helpers/test.ts';

const { models } = JSON.parse(
  readFileSync(resolve(import.meta.dirname, '../public/gallery/index.json'), 'utf8'),
) as { models: { id: string; moves: boolean; made?: boolean; firstStep?: boolean }[] };
test.describe('without looking at the drawing', () => {
  test.use({ draws: false });

  test('the gallery has pictures and figures, and opens its models', async ({ page }) => {
    await page.goto('./?room=gallery');
    const cards = page.locator('.gallery-card');
    await expect(cards).toHaveCount(models.length);
    await expect(page.locator('.gallery-badge').nth(8)).toBeAttached();
    const first = cards.first().locator('img');
    await expect
      .poll(() => first.evaluate((image: HTMLImageElement) => image.naturalWidth))
      .toBe(320);
    await page.locator('[data-model="seesaw"] .gallery-open').click();
    await expect(page.locator('.room')).toHaveCount(0);
    await expect(page.getByLabel('Name of the sketch')).toHaveValue('Seesaw');
  });

  test('small models stand by themselves, as first steps', async ({ page }) => {
    await page.goto('./?room=gallery');
    // The room is a section round it.
    const steps = page
      .locator('section', { has: page.getByRole('heading', { name: 'First steps' }) })
      .last();
    await expect(steps.locator('.gallery-card')).toHaveCount(
      models.filter(({ firstStep }) => firstStep).length,
    );
  });

  test('a large model comes with the page', async ({ page }) => {
    await page.goto('./?room=gallery');
    const made = page.waitForResponse(/made\/castle\.made$/);
    await page.locator('[data-model="castle"] .gallery-open').click();
    expect((await made).ok()).toBe(true);
    await expect(page.getByLabel('Name of the sketch')).toHaveValue('Castle');
    await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 60_000 });
  });

  for (const { id, says, crank, turns } of [
    { id: 'gear-box', says: '15 turns', crank: 7.5, turns: [7.5, -2.5, 0.5] },
    { id: 'winch', says: '3 times', crank: 5, turns: [5, -3, 15] },
  ]) {
    test(`gears of ${id} turn with the right ratio`, async ({ page }) => {
      await page.goto('./?room=gallery');
      const card = page.locator(`[data-model="${id}"]`);
      await card.getByRole('button', { name: 'See the gears turn' }).click();
      await expect(page.getByTestId('ratio')).toContainText(says, { timeout: 90_000 });
      await page.getByLabel('Crank').fill(`${crank}`);
      const shafts = page.locator('.gear-shafts li');
      await expect(shafts).toHaveCount(turns.length);
      for (const [i, wanted] of turns.entries()) {
        await expect(shafts.nth(i)).toHaveAttribute('data-turns', wanted.toFixed(4));
      }
      await page.getByRole('button', { name: 'Open with its gears' }).click();
      const result = page.getByRole('complementary');
      await expect(result.getByText('opened from a file and checked')).toBeVisible();
      await expect(result.getByTestId('verdict')).toContainText('Buildable');
    });
  }
});

const MOVING = models.filter(({ moves }) => moves).map(({ id }) => id);
/** Small ones first: what is tested of them is the page. */
const SMALL = models.filter(({ moves, made }) => moves && !made).map(({ id }) => id);

test('nine models move, or more', () => {
  expect(MOVING.length).toBeGreaterThanOrEqual(9);
});

/** Turns the joint on screen to both ends of its range. */
async function turn(page: Page): Promise<void> {
  const angle = page.getByRole('slider', { name: 'Angle' });
  await expect(angle).toBeVisible({ timeout: 90_000 });
  for (const [key, end] of [
    ['End', 'max'],
    ['Home', 'min'],
  ] as const) {
    // The range is that of the joint before until this one's has come.
    await expect(async () => {
      const [least, most] = await rangeOf(angle);
      expect(most - least).toBeGreaterThan(5);
      await angle.press(key);
      const wanted = Number(await angle.getAttribute(end));
      const off = async () => Math.abs(Number(await angle.inputValue()) - wanted);
      await expect.poll(off, { timeout: 2000 }).toBeLessThanOrEqual(0.5);
    }).toPass();
  }
}

async function rangeOf(angle: Locator): Promise<readonly [number, number]> {
  return [Number(await angle.getAttribute('min')), Number(await angle.getAttribute('max'))];
}

/** Lets the joint on screen move by itself. */
async function play(page: Page): Promise<void> {
  const angle = page.getByRole('slider', { name: 'Angle' });
  const value = async () => Number(await angle.inputValue());
  const least = Number(await angle.getAttribute('min'));
  await page.getByRole('button', { name: 'Play' }).click();
  await expect.poll(value).toBeGreaterThan(least + 0.5);
  await page.getByRole('button', { name: 'Pause' }).click();
  expect(await value()).toBeLessThanOrEqual(Number(await angle.getAttribute('max')));
}

test.describe('every joint turns within its range', () => {
  test.use({ draws: false });

  // Two tests: they run side by side. Every model's joints are judged by tests/contract/gallery.test.ts; here it is
  // the page that turns them.
  for (const half of [0, 1]) {
    const ids = SMALL.filter((_, i) => i % 2 === half).slice(0, 2);
    test(ids.join(', '), async ({ page }) => {
      await page.goto('./?room=gallery');
      for (const id of ids) {
        await page.locator(`[data-model="${id}"]`).getByRole('button', { name: 'Move it' }).click();
        await expect(page.locator(`.gallery-view[data-model="${id}"]`)).toBeVisible();
        const joints = page.locator('.motion-list > li > button');
        await expect(joints.first()).toBeVisible({ timeout: 90_000 });
        for (const joint of await joints.all()) {
          await joint.click();
          await turn(page);
        }
        await play(page);
        await page.getByRole('button', { name: 'Back to the gallery' }).click();
      }
      await expect(page.locator('.gallery-card')).toHaveCount(models.length);
    });
  }

  test('a joint is dragged beside the drawing', async ({ page }) => {
    await page.goto(`./${await linkOf(publicSketch('examples/seesaw'))}`);
    await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 90_000 });
    await page.getByRole('link', { name: 'Move', exact: true }).click();
    const angle = page.getByRole('slider', { name: 'Angle' });
    await angle.scrollIntoViewIfNeeded();
    const box = await steadyBox(angle);
    const middle = box.y + box.height / 2;
    await page.mouse.move(box.x + box.width / 2, middle);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width + 20, middle, { steps: 4 });
    const [, most] = await rangeOf(angle);
    const off = async () => Math.abs(Number(await angle.inputValue()) - most);
    await expect.poll(off).toBeLessThanOrEqual(0.5);
    await page.mouse.up();
  });
});

test.describe('drawn', () => {
  // Small: without a graphics card each pixel counts, also those of the drawing behind the room.
  test.use({ viewport: { width: 640, height: 480 } });

  test('the picture shows where a joint stands', async ({ page }) => {
    await page.goto('./?room=gallery');
    await page.locator('[data-model="seesaw"]').getByRole('button', { name: 'Move it' }).click();
    const angle = page.getByRole('slider', { name: 'Angle' });
    await expect(angle).toBeVisible({ timeout: 90_000 });
    const picture = page.locator('.moving-picture canvas');
    const before = await picture.screenshot();
    await angle.press('End');
    await expect.poll(async () => (await picture.screenshot()).equals(before)).toBe(false);
  });
});
