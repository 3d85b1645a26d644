import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { FIRST_MODEL } from '../web/src/app/first-model.ts';
import { expect, runCommand, test } from './helpers/test.ts';

test.use({ draws: false });

const TOP = resolve(import.meta.dirname, '..');
const PACKAGE = JSON.parse(readFileSync(join(TOP, 'package.json'), 'utf8')) as {
  dependencies: Record<string, string>;
};
const DIST = resolve(import.meta.dirname, '..', process.env['LIFTARM_DIST'] ?? 'dist');

function kilobytes(file: string): number {
  return gzipSync(readFileSync(join(DIST, file))).length / 1000;
}

/** The files that the service worker fetches together: all that drawing and generating need. */
function coreFiles(): string[] {
  const worker = readFileSync(join(DIST, 'sw.js'), 'utf8');
  const list = /const CORE_FILES = \[([^\]]*)\]/.exec(worker)?.[1] ?? '';
  return [...list.matchAll(/'\.\/([^']+)'/g)].flatMap((match) => match[1] ?? []);
}

function sum(files: readonly string[]): number {
  return files.reduce((total, file) => total + kilobytes(file), 0);
}

// Somewhat above what there is: a new dependency or a careless include must show.
test('the first load stays under 1 MB, compressed', () => {
  const files = coreFiles();
  expect(files.length).toBeGreaterThan(10);
  expect(files.filter((file) => !existsSync(join(DIST, file)))).toEqual([]);
  expect(sum(files)).toBeLessThan(1000);
});

test('scripts at the start stay within their budget', () => {
  expect(sum(coreFiles().filter((file) => file.endsWith('.js')))).toBeLessThan(420);
});

test('rooms are loaded on demand', () => {
  const late = readdirSync(join(DIST, 'assets')).filter((name) =>
    /^(make-pdf|prover|linkage|truss-worker|lab-worker|laboratory-room|instructions-room|lessons-room|gallery-room|share-room).*\.js$/.test(
      name,
    ),
  );
  expect(late.length).toBeGreaterThanOrEqual(8);
  const core = new Set(coreFiles());
  expect(late.filter((name) => core.has(`assets/${name}`))).toEqual([]);
});

test('the prover waits for the first proof', () => {
  expect(coreFiles().filter((name) => /highs|prover/.test(name))).toEqual([]);
});

// Frames and axles in the search took 55 kB; the first picture no longer waits for it.
test('the WebAssembly module stays within its budget', () => {
  const modules = readdirSync(join(DIST, 'assets')).filter((name) =>
    /^liftarm-core.*\.wasm$/.test(name),
  );
  expect(sum(modules.map((name) => `assets/${name}`))).toBeLessThan(640);
});

test('the laboratory’s module waits for the laboratory, and stays within its budget', () => {
  const modules = readdirSync(join(DIST, 'assets')).filter((name) =>
    /^liftarm-lab.*\.wasm$/.test(name),
  );
  expect(modules).toHaveLength(1);
  expect(coreFiles().filter((name) => name.includes('liftarm-lab'))).toEqual([]);
  expect(sum(modules.map((name) => `assets/${name}`))).toBeLessThan(820);
});

test('the licences of all that ships are there', async ({ page }) => {
  const text = readFileSync(join(DIST, 'licences.txt'), 'utf8');
  for (const name of [
    ...Object.keys(PACKAGE.dependencies),
    'Eigen',
    'JSON for Modern C++',
    'Emscripten runtime',
    'musl',
    'libc++',
    'Mozilla Public License Version 2.0',
    'LDraw.org Parts Library',
  ]) {
    expect(text).toContain(name);
  }
  await page.goto('./');
  await runCommand(page, 'about');
  const link = page.getByRole('link', { name: 'The licences of all of them' });
  const reply = await page.request.get((await link.getAttribute('href')) ?? 'missing');
  expect(await reply.text()).toBe(text);
});

test('nothing jumps while the page begins', async ({ page }) => {
  await page.addInitScript(() => {
    Object.assign(globalThis, { shift: 0 });
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries() as (PerformanceEntry & { value: number })[]) {
        Object.assign(globalThis, {
          shift: (globalThis as unknown as { shift: number }).shift + entry.value,
        });
      }
    }).observe({ type: 'layout-shift', buffered: true });
  });
  await page.goto('./');
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 90_000 });
  const shift = await page.evaluate(() => (globalThis as unknown as { shift: number }).shift);
  expect(shift).toBeLessThan(0.1);
});

test('the first picture waits neither for the solver nor for the other examples', async ({
  page,
}) => {
  // Held back, not refused: both come after it.
  const asked: string[] = [];
  let release: () => void = () => undefined;
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route(/\.wasm$|worker-.*\.js$|examples\//, async (route) => {
    asked.push(route.request().url());
    await held;
    await route.continue();
  });
  await page.goto('./');
  await expect(page.getByTestId('verdict')).toContainText('Buildable');
  await page.waitForFunction((mark) => performance.getEntriesByName(mark).length > 0, FIRST_MODEL);
  release();
  await expect.poll(() => asked.some((url) => url.endsWith('.wasm'))).toBe(true);
  // The time of the search that confirms it.
  await expect(page.getByText(/^\d+\.\d+ s$/)).toBeVisible({ timeout: 60_000 });
});

test('the module is fetched once, for all workers', async ({ page }) => {
  const asked: string[] = [];
  page.on('request', (request) => {
    if (request.url().endsWith('.wasm')) {
      asked.push(request.resourceType());
    }
  });
  await page.goto('./');
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 90_000 });
  // The markup asks, the script takes what came; service workers ask for themselves, later.
  expect(asked.length).toBeLessThanOrEqual(2);
});

// `style` in markup, inline scripts and foreign addresses are all refused by it.
for (const file of ['index.html', 'embed.html']) {
  test(`${file} has a strict policy and works in any folder`, () => {
    const html = readFileSync(join(DIST, file), 'utf8').replaceAll('&#39;', "'");
    const policy = /Content-Security-Policy" content="([^"]*)"/.exec(html)?.[1] ?? '';
    expect(policy).toContain("default-src 'self'");
    expect(policy).toContain("script-src 'self' 'wasm-unsafe-eval';");
    expect(policy).toContain("object-src 'none'");
    expect(policy).not.toMatch(/unsafe-inline|'unsafe-eval'|https?:|\*/);
    const addresses = [...html.matchAll(/\b(?:src|href)="([^"]*)"/g)].map((match) => match[1]);
    expect(addresses.length).toBeGreaterThan(2);
    expect(addresses.filter((address) => !address?.startsWith('./'))).toEqual([]);
    expect(html).not.toMatch(/<script(?![^>]*\bsrc=)[^>]*>|\sstyle="|\son\w+="/);
  });
}
