import { readFileSync } from 'node:fs';
import { chromium } from '@playwright/test';

/** Debian's browser, as the browser tests have it. */
export function launchBrowser() {
  return chromium.launch({
    executablePath: process.env.LIFTARM_CHROMIUM ?? '/usr/bin/chromium',
    chromiumSandbox: false,
  });
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
