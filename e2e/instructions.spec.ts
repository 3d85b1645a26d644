import { bytesOf, openModelRoom } from './helpers/rooms.ts';
import { expect, test } from './helpers/test.ts';

test.use({ draws: false });

const PICTURE = '.step-picture canvas[data-step]';

test('steps are read, ticked off and remembered', async ({ page }) => {
  await openModelRoom(page, 'instructions', 'examples/square-frame');
  await expect(page.locator(PICTURE)).toHaveAttribute('data-step', '1', { timeout: 90_000 });
  await expect(page.locator('.parts-box .part-tile').first()).toBeVisible();
  await page.keyboard.press('ArrowRight');
  await expect(page.locator(PICTURE)).toHaveAttribute('data-step', '2');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press(' ');
  await expect(page.getByText(/^1 of \d+ steps done$/)).toBeVisible();
  await page.reload();
  await expect(page.getByText(/^1 of \d+ steps done$/)).toBeVisible({ timeout: 90_000 });
  await expect(page.locator(PICTURE)).toHaveAttribute('data-step', '2');
});

test('the PDF and the film are written', async ({ page }) => {
  await openModelRoom(page, 'instructions', 'examples/square-frame');
  await expect(page.locator(PICTURE)).toBeVisible({ timeout: 90_000 });
  for (const paper of ['A4', 'Letter']) {
    const pdf = await bytesOf(page, () =>
      page.getByRole('button', { name: `PDF (${paper})` }).click(),
    );
    expect(pdf.subarray(0, 5).toString('latin1')).toBe('%PDF-');
    expect(pdf.length).toBeGreaterThan(20_000);
  }
  await page.getByRole('radio', { name: 'Film' }).check({ force: true });
  await page.getByLabel('Moment of the film').fill('2');
  await page.getByLabel('Speed').selectOption('4');
  const gif = await bytesOf(page, () => page.getByRole('button', { name: 'Save as GIF' }).click());
  expect(gif.subarray(0, 6).toString('latin1')).toBe('GIF89a');
  const zip = await bytesOf(page, () =>
    page.getByRole('button', { name: 'Save as pictures' }).click(),
  );
  expect(zip.readUInt32LE(0)).toBe(0x04034b50);
  expect(zip.subarray(30, 45).toString('latin1')).toBe('frame-00001.png');
  const video = page.getByRole('button', { name: 'Save as video' });
  if (await video.isVisible()) {
    const film = await bytesOf(page, () => video.click());
    // MP4 names its brand in bytes 4 to 8; WebM begins with EBML's own number.
    expect(
      film.subarray(4, 8).toString('latin1') === 'ftyp' || film.readUInt32BE(0) === 0x1a45dfa3,
    ).toBe(true);
  }
});
