// What another site's frame may do to what this browser keeps: nothing.
import type { Page } from '@playwright/test';
import { encodeShare } from '../web/src/share/codec.ts';
import { linkOf, publicSketch } from './helpers/links.ts';
import { expect, openPage, test } from './helpers/test.ts';
import { VersionServer } from './helpers/version-server.ts';

test.use({ draws: false });

const OWN = { autoSolve: false, seed: 7, owned: { 2780: 50 } };

/** All that the browser keeps for the page that is open. */
function keptText(page: Page): Promise<string> {
  return page.evaluate(async () => {
    const opening = indexedDB.open('liftarm');
    await new Promise((done) => {
      opening.onsuccess = done;
    });
    const table = opening.result.transaction('values').objectStore('values');
    const all = table.getAllKeys();
    await new Promise((done) => {
      all.onsuccess = done;
    });
    opening.result.close();
    return JSON.stringify([all.result, { ...localStorage }]);
  });
}

async function linkWith(settings: { preset: string; owned: Record<string, number> }) {
  const sketch = { ...publicSketch('examples/square-frame'), name: 'Linked' };
  const more = { effort: 2, off: ['32278'], owned: settings.owned, advanced: '' };
  const fragment = await encodeShare({ sketch, preset: settings.preset, seed: 3, settings: more });
  return fragment.ok ? `#${fragment.value}` : '';
}

test('a link’s settings are those of its sketch, and what is not known of them blocks no search', async ({
  page,
}) => {
  await page.addInitScript((own) => {
    if (localStorage.getItem('liftarm/preferences') === null) {
      localStorage.setItem('liftarm/preferences', JSON.stringify(own));
    }
  }, OWN);
  await openPage(page);
  const link = await linkWith({ preset: 'toString', owned: { foo: 1, 32316: 40 } });
  await page.evaluate((hash) => {
    location.hash = hash;
  }, link);
  // The message goes away after a while.
  await Promise.all([
    expect(page.getByLabel('Name of the sketch')).toHaveValue('Linked'),
    expect(page.getByText('left out: preset, foo')).toBeVisible(),
  ]);
  await expect(page.getByLabel('Seed', { exact: true })).toHaveValue('3');
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
  await page.reload();
  await expect(page.getByLabel('Seed', { exact: true })).toHaveValue('3');
  await page.locator('details').evaluateAll((sections) => {
    for (const section of sections) {
      (section as HTMLDetailsElement).open = true;
    }
  });
  await page.getByRole('button', { name: 'Use my settings' }).click();
  await expect(page.getByLabel('Seed', { exact: true })).toHaveValue('7');
  await expect
    .poll(async () =>
      JSON.parse((await page.evaluate(() => localStorage.getItem('liftarm/preferences'))) ?? ''),
    )
    .toMatchObject(OWN);
});

test('in a frame of another origin nothing is kept, and nothing that is kept is changed', async ({
  page,
}) => {
  const server = await VersionServer.start();
  await page.goto(server.address);
  await page.evaluate((own) => {
    localStorage.setItem('liftarm/preferences', JSON.stringify(own));
  }, OWN);
  await expect(page.locator('html')).toHaveAttribute('data-kept', 'kept');
  const before = await keptText(page);
  const link = await linkWith({ preset: 'faithful', owned: {} });
  // Of the same site, by its port another origin: it has the very storage. A page of somebody else's, with no policy.
  await page.route('**/favicon.ico', (route) => route.fulfill({ status: 204 }));
  await page.goto('./licences.txt');
  await page.evaluate((address) => {
    const element = document.createElement('iframe');
    Object.assign(element, { src: address, width: '1000', height: '700' });
    document.body.replaceChildren(element);
  }, server.address + link);
  const frame = page.frameLocator('iframe');
  await expect(frame.getByLabel('Name of the sketch')).toHaveValue('Linked', { timeout: 90_000 });
  await expect(frame.getByRole('alert')).toContainText('nothing is kept');
  await frame.getByLabel('Name of the sketch').fill('Drawn in a frame');
  await frame.getByLabel('Name of the sketch').press('Enter');
  await expect(frame.locator('html')).toHaveAttribute('data-kept', 'kept');
  await page.goto(server.address);
  await expect(page.locator('html')).toHaveAttribute('data-kept', 'kept');
  expect(await keptText(page)).toBe(before);
  await page.goto('about:blank');
  await server.stop();
});

test('the viewer keeps nothing', async ({ page }) => {
  await page.goto(`./embed.html${await linkOf(publicSketch('examples/square-frame'))}`);
  await expect(page.locator('.embed-status')).toHaveAttribute('data-bricks', '8', {
    timeout: 90_000,
  });
  const kept = await page.evaluate(async () => ({
    databases: (await indexedDB.databases()).length,
    texts: localStorage.length + sessionStorage.length,
    caches: (await caches.keys()).length,
    workers: (await navigator.serviceWorker.getRegistrations()).length,
  }));
  expect(kept).toEqual({ databases: 0, texts: 0, caches: 0, workers: 0 });
});

test('another site cannot show the page in a frame, where the host can say so', async ({
  request,
}) => {
  const page = await request.get('./');
  expect(page.headers()['content-security-policy']).toContain("frame-ancestors 'self'");
  expect((await request.get('./_headers')).ok()).toBe(true);
});
