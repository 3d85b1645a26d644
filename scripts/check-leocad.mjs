// `node scripts/check-leocad.mjs [--out DIR]`: solves every gallery model, lets LeoCAD render its LDraw
// file without a screen, and draws ours beside it. Needs leocad, xvfb, xauth and the LDraw geometry of
// ../shared/ldraw. Ends with 1 when LeoCAD complains, misses a part, or draws nothing.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import gifenc from 'gifenc';
import { encodePng } from './lib/indexed-png.mjs';
import { loadCore } from './lib/load-core.mjs';
import { loadTypeScript } from './lib/load-typescript.mjs';
import { drawSheet, launchBrowser } from './lib/picture-sheet.mjs';
import { capture, exitWith, StepError, TOP } from './lib/run.mjs';

const GALLERY = resolve(TOP, 'public/gallery');
const LDRAW = resolve(TOP, '../shared/ldraw');
const SIZE = { width: 900, height: 700, margin: 20 };
const SCREEN = '-screen 0 1280x1024x24 +extension GLX';

const { values: options } = parseArgs({
  options: {
    out: { type: 'string', default: resolve(TOP, 'build/leocad') },
    command: { type: 'string', default: resolve(TOP, 'build/native/liftarm') },
    only: { type: 'string' },
  },
});

/** What LeoCAD says and draws. */
function render(mpd, picture) {
  rmSync(picture, { force: true });
  const args = ['-a', '-s', SCREEN, 'leocad', '-l', LDRAW, '-i', picture];
  const size = ['-w', `${SIZE.width}`, '-h', `${SIZE.height}`];
  const result = spawnSync('xvfb-run', [...args, ...size, mpd], {
    encoding: 'utf8',
    timeout: 120_000,
  });
  return { code: result.status, said: `${result.stdout ?? ''}${result.stderr ?? ''}`.trim() };
}

/** Part files that the document names and the library does not have. */
function missingParts(mpd) {
  const named = new Set();
  for (const line of readFileSync(mpd, 'utf8').split('\n')) {
    const fields = line.trim().split(/\s+/);
    if (fields[0] === '1' && fields.at(-1).endsWith('.dat')) {
      named.add(fields.at(-1));
    }
  }
  return [...named].filter((file) => !existsSync(join(LDRAW, 'parts', file)));
}

function drawOurs(model, file, tools) {
  const parts = model.parts.map(tools.drawn);
  const points = parts.flatMap((part) => tools.shelf.corners(part));
  const picture = tools.drawPicture(
    parts,
    tools.cameraFor(points, tools.ISO_OUT, SIZE),
    tools.shelf,
  );
  const palette = gifenc.quantize(picture.data, 128, { format: 'rgba4444' });
  const indices = gifenc.applyPalette(picture.data, palette, 'rgba4444');
  writeFileSync(file, encodePng(picture.width, picture.height, indices, palette));
}

/** Puts the gears of a row into its model, and exports that once more with the shipped module. */
function addGears(row, stem, tools, core) {
  const gears = JSON.parse(readFileSync(resolve(GALLERY, row.gears), 'utf8'));
  const train = tools.readGearTrain(gears, tools.catalogue);
  if (!train.ok) {
    throw new StepError(`${row.id}: ${train.message}`);
  }
  const frame = readFileSync(`${stem}.model.json`, 'utf8');
  const whole = tools.withTrain(frame, train.value, tools.catalogue);
  const { status, text } = core.exportModel(whole, 'mpd');
  if (status !== 'ok') {
    throw new StepError(`${row.id}: ${text}`);
  }
  writeFileSync(`${stem}.model.json`, whole);
  writeFileSync(`${stem}.mpd`, text);
}

/** Ours and LeoCAD's side by side, two models in a row. */
async function layOut(pictures) {
  const browser = await launchBrowser();
  try {
    const page = await browser.newPage({ viewport: { width: 1320, height: 800 } });
    await drawSheet(page, pictures, join(options.out, 'sheet.png'), 310);
  } finally {
    await browser.close();
  }
}

async function main() {
  if (!existsSync(LDRAW)) {
    throw new StepError('../shared/ldraw is not there');
  }
  const { tools } = await loadTypeScript('scripts/lib/gallery-tools.ts');
  const core = await loadCore();
  mkdirSync(options.out, { recursive: true });
  const { models } = JSON.parse(readFileSync(resolve(GALLERY, 'index.json'), 'utf8'));
  const faults = [];
  const pictures = [];
  for (const row of models.filter(({ id }) => !options.only || id === options.only)) {
    const args = ['solve', resolve(GALLERY, row.file), '-o', options.out, '--seed', '1', '--json'];
    const { code } = capture(options.command, args);
    const stem = join(options.out, row.file.split('/').at(-1).replace('.sketch.json', ''));
    if (row.gears) {
      addGears(row, stem, tools, core);
    }
    const mpd = `${stem}.mpd`;
    const picture = `${stem}.leocad.png`;
    const { said } = render(mpd, picture);
    const missing = missingParts(mpd);
    const drawn = existsSync(picture) && statSync(picture).size > 5000;
    if (code !== 0 || missing.length > 0 || !drawn) {
      faults.push(`${row.id}: exit ${code}, missing ${missing.join(' ') || 'none'}, ${said}`);
    }
    drawOurs(JSON.parse(readFileSync(`${stem}.model.json`, 'utf8')), `${stem}.ours.png`, tools);
    pictures.push(
      { file: `${stem}.ours.png`, title: `${row.id}, ours` },
      ...(drawn ? [{ file: picture, title: `${row.id}, LeoCAD` }] : []),
    );
    console.log(`${row.id.padEnd(16)} ${drawn ? 'drawn' : 'NOT DRAWN'} ${said.split('\n')[0]}`);
  }
  await layOut(pictures);
  if (faults.length > 0) {
    throw new StepError(faults.join('\n'));
  }
}

main().catch(exitWith);
