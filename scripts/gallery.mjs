// `node scripts/gallery.mjs`: solves every model of the gallery, writes its figures into
// public/gallery/index.json and draws its thumbnail with the page's own renderer. Ends with 1 when a
// model is not buildable. `--check` compares only, and writes nothing.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import gifenc from 'gifenc';
import { encodePng } from './lib/indexed-png.mjs';
import { loadTypeScript } from './lib/load-typescript.mjs';
import { capture, exitWith, StepError, TOP } from './lib/run.mjs';

const FOLDER = resolve(TOP, 'public/gallery');
const SIZE = { width: 320, height: 240, margin: 12 };
const COLOURS = 64;
/** Thin lines: a thumbnail is small. */
const STYLE = { detail: 'high', smooth: 3, line: 0.34 };

const { values: options } = parseArgs({
  options: {
    check: { type: 'boolean', default: false },
    command: { type: 'string', default: resolve(TOP, 'build/native/liftarm') },
  },
});

/** Solves with the first seed. @returns report and model. */
function solve(row) {
  const out = join(tmpdir(), 'liftarm-gallery');
  const { stdout, code } = capture(options.command, [
    'solve',
    resolve(FOLDER, row.file),
    '-o',
    out,
    '--seed',
    '1',
    '--json',
  ]);
  if (code !== 0) {
    throw new StepError(`${row.id}: not buildable (${stdout.slice(0, 300)})`);
  }
  const stem = row.file.split('/').at(-1).replace('.sketch.json', '');
  const model = JSON.parse(readFileSync(join(out, `${stem}.model.json`), 'utf8'));
  return { report: JSON.parse(stdout), model };
}

/** The gears of a model in their places, so that they are on its picture. */
function gearParts(row, tools) {
  if (!row.gears) {
    return [];
  }
  const json = JSON.parse(readFileSync(resolve(FOLDER, row.gears), 'utf8'));
  const train = tools.readGearTrain(json, tools.catalogue);
  if (!train.ok) {
    throw new StepError(`${row.id}: ${train.message}`);
  }
  return tools.placeTrain(train.value, 0, tools.catalogue);
}

function drawThumbnail(row, parts, tools) {
  const shown = parts.map(tools.drawn);
  const points = shown.flatMap((part) => tools.shelf.corners(part));
  const camera = tools.cameraFor(points, tools.ISO_OUT, SIZE);
  const picture = tools.drawPicture(shown, camera, tools.shelf, STYLE);
  const palette = gifenc.quantize(picture.data, COLOURS, { format: 'rgba4444' });
  const indices = gifenc.applyPalette(picture.data, palette, 'rgba4444');
  writeFileSync(
    resolve(FOLDER, 'thumbs', `${row.id}.png`),
    encodePng(picture.width, picture.height, indices, palette),
  );
}

async function main() {
  const { tools } = await loadTypeScript('scripts/lib/gallery-tools.ts');
  const index = JSON.parse(readFileSync(resolve(FOLDER, 'index.json'), 'utf8'));
  mkdirSync(resolve(FOLDER, 'thumbs'), { recursive: true });
  const rows = [];
  for (const row of index.models) {
    const { report, model } = solve(row);
    const gears = gearParts(row, tools);
    const gearMass = gears.reduce((sum, { part }) => sum + tools.catalogue.find(part).mass, 0);
    const figures = {
      beams: report.beams,
      bricks: report.bricks + gears.length,
      mass: Math.round(report.mass + gearMass),
    };
    console.log(`${row.id.padEnd(16)} ${figures.beams} beams, ${figures.bricks} parts`);
    rows.push({ ...row, ...figures });
    if (!options.check) {
      drawThumbnail(row, [...model.parts, ...gears], tools);
    }
  }
  if (!options.check) {
    const lines = rows.map((row) => JSON.stringify(row)).join(',\n');
    const head = '{"format":"liftarm-gallery","version":1,"models":[\n';
    writeFileSync(resolve(FOLDER, 'index.json'), `${head}${lines}\n]}\n`);
  }
}

main().catch(exitWith);
