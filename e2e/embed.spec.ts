import { linkOf, publicSketch } from './helpers/links.ts';
import { expect, test } from './helpers/test.ts';

test('the viewer shows the model of a link without panels', async ({ page }) => {
  await page.goto(`./embed.html${await linkOf(publicSketch('examples/square-frame'))}`);
  await expect(page.locator('canvas')).toBeVisible();
  await expect(page.locator('.embed-status')).toHaveAttribute('data-bricks', '8', {
    timeout: 90_000,
  });
  await expect(page.getByRole('link', { name: 'Open in Liftarm' })).toHaveAttribute('href', /#s/);
  await expect(page.locator('.panel')).toHaveCount(0);
});

test('a broken link gives a sentence in the viewer', async ({ page }) => {
  await page.goto('./embed.html#s2.<img src=x onerror=alert(1)>.0');
  await expect(page.getByRole('status')).toContainText('damaged');
});

test('the viewer loads nothing heavy before it is seen', async ({ page, baseURL }) => {
  const scripts: string[] = [];
  page.on('request', (request) => scripts.push(new URL(request.url()).pathname));
  // A page of someone else's, with the viewer far below what is seen.
  await page.goto('about:blank');
  await page.setContent(
    `<div style="height:20000px"></div><iframe src="${baseURL}/embed.html" loading="lazy"></iframe>`,
  );
  await page.waitForTimeout(1500);
  expect(scripts.filter((path) => path.endsWith('.wasm') || path.includes('viewer'))).toEqual([]);
});
