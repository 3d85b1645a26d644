import { readFileSync } from 'node:fs';
import { chromium } from '@playwright/test';
import { BROWSER } from './browser.mjs';

/** Debian's browser, as the browser tests have it. */
export function launchBrowser() {
  return chromium.launch(BROWSER);
}

/**
 * Lays pictures out in rows on one picture.
 * @param page one of the browser's, for nothing else
 * @param pictures files (PNG) with their titles
 * @param width pixels of each; as they are when left out
 */
export async function drawSheet(page, pictures, path, width) {
  const shown = pictures.map(({ file, title }) => {
    const bytes = readFileSync(file).toString('base64');
    const size = width ? `width="${width}"` : '';
    return `<figure style="display:inline-block;margin:4px;font:12px sans-serif">
      <img ${size} style="border:1px solid #888" src="data:image/png;base64,${bytes}">
      <figcaption>${title}</figcaption></figure>`;
  });
  await page.setContent(shown.join(''));
  await page.screenshot({ path, fullPage: true });
}

/**
 * How much two pictures on a plain or transparent ground show the same outline, wherever and however large
 * they show it. @returns area of both over area of either, 0 to 1.
 */
export function outlineOverlap(page, fileA, fileB) {
  const [a, b] = [fileA, fileB].map((file) => readFileSync(file).toString('base64'));
  return page.evaluate(overlapThere, { a, b });
}

/** Runs in the browser. */
async function overlapThere({ a, b }) {
  const grid = 256;
  const outline = async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.fillStyle = 'white';
    context.fillRect(0, 0, image.width, image.height);
    context.drawImage(image, 0, 0);
    const { data: pixels, width, height } = context.getImageData(0, 0, image.width, image.height);
    const filled = (x, y) => {
      const at = 4 * (Math.floor(y) * width + Math.floor(x));
      return [0, 1, 2].some((k) => Math.abs(pixels[at + k] - pixels[k]) > 12);
    };
    const box = { left: width, right: 0, top: height, bottom: 0 };
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        if (filled(x, y)) {
          box.left = Math.min(box.left, x);
          box.right = Math.max(box.right, x + 1);
          box.top = Math.min(box.top, y);
          box.bottom = Math.max(box.bottom, y + 1);
        }
      }
    }
    return (i, j) =>
      filled(
        box.left + ((i + 0.5) / grid) * (box.right - box.left),
        box.top + ((j + 0.5) / grid) * (box.bottom - box.top),
      );
  };
  const [first, second] = [await outline(a), await outline(b)];
  let both = 0;
  let either = 0;
  for (let i = 0; i < grid; i++) {
    for (let j = 0; j < grid; j++) {
      const [p, q] = [first(i, j), second(i, j)];
      both += p && q ? 1 : 0;
      either += p || q ? 1 : 0;
    }
  }
  return either > 0 ? both / either : 0;
}
