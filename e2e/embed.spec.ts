import { linkOf, publicSketch } from './helpers/links.ts';
import { expect, test } from './helpers/test.ts';

// Small, as in other people's pages: without a graphics card each pixel counts.
test.use({ viewport: { width: 400, height: 300 } });

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

test('the viewer loads nothing heavy before it is seen', async ({ page }) => {
  const heavy: string[] = [];
  page.on('request', (request) => {
    const { pathname } = new URL(request.url());
    if (pathname.endsWith('.wasm') || pathname.includes('viewer')) {
      heavy.push(pathname);
    }
  });
  const link = await linkOf(publicSketch('examples/square-frame'));
  // A page of someone else's, with the viewer far below what is seen.
  const html = `<div style="height:20000px"></div><iframe src="./embed.html${link}"></iframe>`;
  await page.route('**/someone-else.html', (route) =>
    route.fulfill({ contentType: 'text/html', body: html }),
  );
  await page.goto('./someone-else.html', { waitUntil: 'load' });
  await expect(page.frameLocator('iframe').locator('#viewer')).toBeAttached();
  expect(heavy).toEqual([]);
  await page.locator('iframe').scrollIntoViewIfNeeded();
  const viewer = page.frameLocator('iframe');
  await expect(viewer.locator('.embed-status')).toHaveAttribute('data-bricks', '8', {
    timeout: 90_000,
  });
  expect(heavy.some((path) => path.endsWith('.wasm'))).toBe(true);
});
