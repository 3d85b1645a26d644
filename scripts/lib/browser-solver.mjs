// The shipped WebAssembly module in a real Chromium, without the page around it.
import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { launchBrowser } from './picture-sheet.mjs';
import { TOP } from './run.mjs';

const WASM = resolve(TOP, process.env.LIFTARM_WASM ?? 'build/wasm');
// Never asked of any network: every request is answered here.
const ORIGIN = 'http://liftarm.localhost';
const TYPES = new Map([
  ['liftarm-core.js', 'text/javascript'],
  ['liftarm-core.wasm', 'application/wasm'],
]);
const PAGE = `<!doctype html><title>solver</title><script type="module">
  import create from '/liftarm-core.js';
  globalThis.liftarmCore = await create();
</script>`;

async function answer(route) {
  const name = new URL(route.request().url()).pathname.slice(1);
  const contentType = TYPES.get(name);
  if (contentType === undefined) {
    await route.fulfill({ contentType: 'text/html', body: PAGE });
    return;
  }
  await route.fulfill({ contentType, body: readFileSync(join(WASM, name)) });
}

/** Runs in the browser. */
function solveThere({ sketch, settings, slice }) {
  const start = performance.now();
  const session = new globalThis.liftarmCore.SolverSession(sketch, settings);
  const { status, text } = session.opened();
  if (status !== 'ok') {
    throw new Error(text);
  }
  while (!session.advance(slice)) {
    // The search goes on.
  }
  const seconds = (performance.now() - start) / 1000;
  const model = session.modelJson();
  session.delete();
  return { seconds, model };
}

/** Runs in the browser. */
function checkThere({ checks, model, repeats }) {
  const timed = (name, more) => {
    const start = performance.now();
    const { status, text } = globalThis.liftarmCore[name](model, ...more);
    if (status !== 'ok') {
      throw new Error(text);
    }
    return performance.now() - start;
  };
  const first = checks.map(([, name, more]) => timed(name, more));
  return checks.map(([, name, more], i) => {
    const later = Array.from({ length: repeats }, () => timed(name, more)).sort((a, b) => a - b);
    return { first: first[i], later: later[Math.floor(repeats / 2)] };
  });
}

async function openPage() {
  const browser = await launchBrowser();
  const page = await browser.newPage();
  await page.route(`${ORIGIN}/**`, answer);
  await page.goto(`${ORIGIN}/`);
  await page.waitForFunction(() => globalThis.liftarmCore !== undefined);
  return { browser, page };
}

/**
 * The checks of a model in a browser just started.
 * @param checks as CHECKS of bench-checks.mjs
 * @returns {Promise<{first: number, later: number}[]>} milliseconds on the wall, one row for each check
 */
export async function timeChecksInBrowser(checks, model, repeats) {
  const { browser, page } = await openPage();
  try {
    return await page.evaluate(checkThere, { checks, model, repeats });
  } finally {
    await browser.close();
  }
}

/** @returns `solve(sketchJson, settings)` -> {seconds, model}, and `close()`. */
export async function openBrowserSolver(slice = 500) {
  const { browser, page } = await openPage();
  return {
    solve: (sketch, settings) =>
      page.evaluate(solveThere, { sketch, settings: JSON.stringify(settings), slice }),
    close: () => browser.close(),
  };
}
