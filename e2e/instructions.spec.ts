import type { Page } from '@playwright/test';
import { countFrames, readImage, readPdf, readVideo, readZip } from './helpers/readers.ts';
import { bytesOf, openModelRoom } from './helpers/rooms.ts';
import { expect, settled, steadyBox, test } from './helpers/test.ts';

test.use({ draws: false });

const PICTURE = '.step-picture canvas[data-step]';

/** Draws over the step: to the left, when `by` is below zero, for the next one. */
async function swipe(page: Page, by: number): Promise<void> {
  const box = await steadyBox(page.locator('.step-picture'));
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + by, y, { steps: 3 });
  await page.mouse.up();
}

test('steps are read, ticked off and remembered', async ({ page }) => {
  await openModelRoom(page, 'instructions', 'examples/square-frame');
  await expect(page.locator(PICTURE)).toHaveAttribute('data-step', '1', { timeout: 90_000 });
  await expect(page.locator('.parts-box .part-tile').first()).toBeVisible();
  await page.keyboard.press('ArrowRight');
  await expect(page.locator(PICTURE)).toHaveAttribute('data-step', '2');
  await page.keyboard.press('ArrowLeft');
  await expect(page.locator(PICTURE)).toHaveAttribute('data-step', '1');
  await swipe(page, 200);
  await expect(page.locator(PICTURE)).toHaveAttribute('data-step', '1');
  await swipe(page, -200);
  await expect(page.locator(PICTURE)).toHaveAttribute('data-step', '2');
  await page.keyboard.press('Home');
  await expect(page.locator(PICTURE)).toHaveAttribute('data-step', '1');
  await page.keyboard.press(' ');
  await expect(page.getByText(/^1 of \d+ steps done$/)).toBeVisible();
  await page.reload();
  await expect(page.getByText(/^1 of \d+ steps done$/)).toBeVisible({ timeout: 90_000 });
  await expect(page.locator(PICTURE)).toHaveAttribute('data-step', '2');
});

test('a step asks for as many parts as the reader likes', async ({ page }) => {
  await openModelRoom(page, 'instructions', 'examples/square-frame');
  await expect(page.locator(PICTURE)).toBeVisible({ timeout: 90_000 });
  const steps = page.getByRole('progressbar', { name: 'Done' });
  const size = page.getByRole('slider', { name: 'Parts a step' });
  const count = async () => Number(await steps.getAttribute('max'));
  const usual = await count();
  await size.fill('1');
  await expect.poll(count).toBeGreaterThan(usual);
  await size.fill('6');
  await expect.poll(count).toBeLessThanOrEqual(usual);
  await page.reload();
  await expect(size).toHaveValue('6');
});

for (const [paper, width, height] of [
  ['A4', 595, 842],
  ['Letter', 612, 792],
] as const) {
  test(`the PDF has all steps on pages of ${paper}`, async ({ page }) => {
    // Each page is drawn by the processor.
    test.setTimeout(240_000);
    await openModelRoom(page, 'instructions', 'examples/square-frame');
    await expect(page.locator(PICTURE)).toBeVisible({ timeout: 90_000 });
    const steps = await page.getByRole('progressbar', { name: 'Done' }).getAttribute('max');
    const pdf = readPdf(
      await bytesOf(page, () => page.getByRole('button', { name: `PDF (${paper})` }).click()),
    );
    expect(pdf.title).toBe('Square frame');
    expect([pdf.width, pdf.height].map(Math.round)).toEqual([width, height]);
    // A cover, the parts, and two steps a page.
    expect(pdf.pages).toBe(2 + Math.ceil(Number(steps) / 2));
    const [cover = '', parts = '', ...rest] = pdf.texts;
    expect(cover).toContain('Square frame');
    expect(cover).toContain(`${steps} steps`);
    expect(parts).toMatch(/4x\s+\d+/);
    rest.forEach((text, i) => {
      expect(text).toMatch(new RegExp(`^\\s*${2 * i + 1}\\s`));
      expect(text).toMatch(new RegExp(`\\b${i + 3} ?/ ?${pdf.pages}\\s*$`));
    });
  });
}

/** Opens the film, four times as fast. @returns its length then, in seconds. */
async function openFilm(page: Page): Promise<number> {
  await openModelRoom(page, 'instructions', 'examples/square-frame');
  await expect(page.locator(PICTURE)).toBeVisible({ timeout: 90_000 });
  await page.getByRole('radio', { name: 'Film' }).check({ force: true });
  const moment = page.getByLabel('Moment of the film');
  await moment.fill('2');
  const seconds = Number(await moment.getAttribute('max')) / 4;
  await page.getByLabel('Speed').selectOption('4');
  return seconds;
}

const save = (page: Page, words: string) =>
  bytesOf(page, () => page.getByRole('button', { name: words }).click());

test('the film is written as GIF', async ({ page }) => {
  const seconds = await openFilm(page);
  const gif = await save(page, 'Save as GIF');
  expect(await readImage(page, gif, 'image/gif')).toMatchObject({ width: 480, height: 360 });
  expect(await countFrames(page, gif)).toBe(Math.ceil(seconds * 10));
});

test('the film is written as pictures', async ({ page }) => {
  const seconds = await openFilm(page);
  const pictures = readZip(await save(page, 'Save as pictures'));
  expect(pictures).toHaveLength(Math.ceil(seconds * 10));
  expect(pictures[0]?.[0]).toBe('frame-00001.png');
});

test('the film is written as a video, where the browser can', async ({ page }) => {
  const seconds = await openFilm(page);
  await expect(page.getByRole('button', { name: 'Save as GIF' })).toBeEnabled();
  await settled(page);
  if (await page.getByRole('button', { name: 'Save as video' }).isVisible()) {
    const film = await save(page, 'Save as video');
    const type = film.subarray(4, 8).toString('latin1') === 'ftyp' ? 'video/mp4' : 'video/webm';
    const facts = await readVideo(page, film, type);
    expect(facts).toMatchObject({ width: 1280, height: 720 });
    expect(Math.abs(facts.seconds - seconds)).toBeLessThan(0.2);
  }
});
