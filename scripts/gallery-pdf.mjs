// `npm run gallery:pdf [-- --only ID,ID] [--paper A4|Letter] [--lang de]`: saves the instructions of
// every gallery model as PDF with the built page, and lays their pages out on one sheet a model, to be
// looked at: build/pdf/ID.sheet.png. Needs dist/, build/wasm/, Chromium, and pdftoppm for the sheets.
import { spawn, spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, rmSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { openGallery } from './lib/gallery.mjs';
import { drawSheet, launchBrowser } from './lib/picture-sheet.mjs';
import { exitWith, freePort, StepError, TOP } from './lib/run.mjs';

const PATIENCE_MS = 600_000;
/** Dots an inch of the sheets: enough to see overlaps and cut words. */
const SHEET_DENSITY = 48;

const { values: options } = parseArgs({
  options: {
    out: { type: 'string', default: resolve(TOP, 'build/pdf') },
    only: { type: 'string' },
    paper: { type: 'string', default: 'A4' },
    lang: { type: 'string', default: 'en' },
  },
});

/** Opens a model in the page and saves its instructions. @returns the PDF's file. */
async function savePdf(page, model, row) {
  const file = { name: `${row.id}.model.json`, mimeType: 'application/json' };
  await (await fileDialog(page)).setFiles({ ...file, buffer: Buffer.from(model) });
  const parts = JSON.parse(model).parts.length;
  await page.locator('dd', { hasText: new RegExp(`^${parts}$`) }).waitFor();
  await page.getByTestId('verdict').waitFor();
  await goTo(page, '?room=instructions');
  await page.locator('.step-picture canvas[data-step]').waitFor();
  const [saved] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: `(${options.paper})` }).click(),
  ]);
  const path = join(options.out, `${row.id}.pdf`);
  await saved.saveAs(path);
  return path;
}

/** The browser opens its dialog only within five seconds of the key: a busy machine may need another. */
async function fileDialog(page) {
  for (let tries = 0; tries < 6; tries++) {
    const waiting = page.waitForEvent('filechooser', { timeout: 10_000 }).catch(() => undefined);
    await page.keyboard.press('Control+o');
    const dialog = await waiting;
    if (dialog) {
      return dialog;
    }
  }
  throw new StepError('the page opened no file dialog');
}

/** As the browser's own buttons do it: the page is not loaded again. */
function goTo(page, search) {
  return page.evaluate((to) => {
    history.pushState(history.state, '', to);
    window.dispatchEvent(new PopStateEvent('popstate'));
  }, search);
}

/** Lays the pages of a PDF out on one picture. @returns how many there are. */
async function layOut(sheet, pdf, row) {
  const folder = join(options.out, row.id);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder);
  const args = ['-png', '-r', `${SHEET_DENSITY}`, pdf, join(folder, 'page')];
  if (spawnSync('pdftoppm', args).status !== 0) {
    throw new StepError('pdftoppm is missing (Debian: poppler-utils) or refused the file');
  }
  const pages = readdirSync(folder).sort();
  const pictures = pages.map((title) => ({ file: join(folder, title), title }));
  await drawSheet(sheet, pictures, join(options.out, `${row.id}.sheet.png`));
  return pages.length;
}

/** One for each model, so that none finds what the page has kept of the last. */
async function openContext(browser) {
  const context = await browser.newContext({ locale: options.lang, reducedMotion: 'reduce' });
  context.setDefaultTimeout(PATIENCE_MS);
  await context.addInitScript(() => {
    localStorage.setItem('liftarm/preferences', JSON.stringify({ autoSolve: false }));
  });
  return context;
}

async function main() {
  const { rows, solve } = await openGallery(options.only);
  mkdirSync(options.out, { recursive: true });
  const port = await freePort(4480);
  const server = spawn(process.execPath, ['scripts/serve.mjs', '--port', `${port}`], { cwd: TOP });
  await new Promise((ready) => server.stdout.once('data', ready));
  const browser = await launchBrowser();
  try {
    const sheet = await browser.newPage();
    for (const row of rows) {
      const context = await openContext(browser);
      const page = await context.newPage();
      await page.goto(`http://127.0.0.1:${port}/`);
      await page.locator('.scene canvas').waitFor();
      const pdf = await savePdf(page, solve(row).json, row);
      await context.close();
      console.log(`${row.id.padEnd(16)} ${await layOut(sheet, pdf, row)} pages`);
    }
  } finally {
    await browser.close();
    server.kill();
  }
}

main().catch(exitWith);
