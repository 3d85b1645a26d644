import type { Page } from '@playwright/test';
import { linkOf, publicSketch } from './helpers/links.ts';
import { bytesOf } from './helpers/rooms.ts';
import { expect, test, withoutDrawing } from './helpers/test.ts';
import { VersionServer } from './helpers/version-server.ts';

test.use({ draws: false });

/** Waits until the service worker has everything and serves the page. */
async function installed(page: Page): Promise<void> {
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
    const name = (await caches.keys()).find((key) => key.startsWith('liftarm-'));
    const cache = await caches.open(name ?? '');
    for (let i = 0; i < 200; i++) {
      const rooms = (await cache.keys()).filter(({ url }) => url.includes('share-room'));
      if (rooms.length > 0) {
        return;
      }
      await new Promise((resolve) => setTimeout(resolve, 200));
    }
    throw new Error('the rooms were not kept');
  });
}

async function modelOf(page: Page): Promise<string> {
  await expect(page.getByTestId('verdict')).toBeAttached({ timeout: 90_000 });
  await expect(page.getByRole('button', { name: 'Model (.json)' })).toBeEnabled();
  const file = await bytesOf(page, () =>
    page.getByRole('button', { name: 'Model (.json)' }).click(),
  );
  return file.toString('utf8');
}

test('a link opens without a network and gives the same model, byte for byte', async ({
  page,
  browser,
}) => {
  test.setTimeout(240_000);
  const server = await VersionServer.start();
  const address = server.address;
  const link = `?room=share${await linkOf(publicSketch('gallery/claw'))}`;
  const context = await browser.newContext();
  const other = await context.newPage();
  await other.addInitScript(withoutDrawing);
  const first = async () => {
    await page.goto(address + link);
    return modelOf(page);
  };
  const second = async () => {
    await other.goto(address);
    await installed(other);
  };
  const [online] = await Promise.all([first(), second()]);
  // Made in the one profile, as it stands in its address; opened in the other, without a network.
  await expect(page).toHaveURL(/#s\d+\./);
  const made = page.url();
  // The first profile may be fetching its service worker still, which would fail aloud.
  await page.goto('about:blank');
  await server.stop();
  await other.goto(made);
  expect(await modelOf(other)).toBe(online);
  await context.close();
});

test('a new version asks first, and no sketch is lost', async ({ page }) => {
  test.setTimeout(240_000);
  const server = await VersionServer.start();
  await page.goto(
    server.address + (await linkOf({ ...publicSketch('gallery/claw'), name: 'Mine' })),
  );
  await installed(page);
  await page.reload();
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Mine');
  server.version = 2;
  await page.evaluate(async () => {
    await (await navigator.serviceWorker.getRegistration())?.update();
  });
  await expect(page.getByText('A new version is ready')).toBeVisible({ timeout: 60_000 });
  const reloaded = page.waitForEvent('load', { timeout: 60_000 });
  await page.getByRole('button', { name: 'Reload' }).click();
  await reloaded;
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Mine');
  // The old version's goes when the new one takes over, which may still be going on.
  const kept = async () =>
    (await page.evaluate(() => caches.keys())).flatMap(
      (name) => /^liftarm-(v\d+)-/.exec(name)?.[1] ?? [],
    );
  await expect.poll(kept).toEqual(['v2']);
  await server.stop();
});

test('the page can be installed', async ({ page, request }) => {
  await page.goto('./');
  const manifest = (await (await request.get('./manifest.webmanifest')).json()) as {
    start_url: string;
    display: string;
    icons: { src: string; sizes: string; purpose?: string }[];
  };
  expect(manifest).toMatchObject({ start_url: './', display: 'standalone' });
  for (const size of ['192x192', '512x512']) {
    const icon = manifest.icons.find(({ sizes }) => sizes === size);
    expect((await request.get(icon?.src ?? 'missing')).ok()).toBe(true);
  }
  expect(manifest.icons.some(({ purpose }) => purpose === 'maskable')).toBe(true);
});
