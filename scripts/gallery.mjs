// `npm run gallery [-- --check]`: solves every model of the gallery, writes its figures into
// public/gallery/index.json and draws its thumbnail with the page's own renderer. Ends with 1 when a
// model is not buildable. `--check` compares only, and writes nothing. Needs build/wasm.
import { mkdirSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { drawParts, GALLERY, openGallery } from './lib/gallery.mjs';
import { exitWith, StepError } from './lib/run.mjs';

/** Thin lines: a thumbnail is small. */
const THUMBNAIL = {
  size: { width: 320, height: 240, margin: 12 },
  colours: 64,
  style: { detail: 'high', smooth: 3, line: 0.34 },
};

const { values: options } = parseArgs({ options: { check: { type: 'boolean', default: false } } });

async function main() {
  const { tools, rows, solve } = await openGallery();
  mkdirSync(resolve(GALLERY, 'thumbs'), { recursive: true });
  const lines = [];
  for (const row of rows) {
    const { report, json, gears } = solve(row);
    if (!report.buildable) {
      throw new StepError(`${row.id}: not buildable (${JSON.stringify(report.problems)})`);
    }
    const gearMass = gears.reduce((sum, { part }) => sum + tools.catalogue.find(part).mass, 0);
    const figures = {
      beams: report.beams,
      bricks: report.bricks + gears.length,
      mass: Math.round(report.mass + gearMass),
    };
    console.log(`${row.id.padEnd(16)} ${figures.beams} beams, ${figures.bricks} parts`);
    lines.push(JSON.stringify({ ...row, ...figures }));
    if (!options.check) {
      const file = resolve(GALLERY, 'thumbs', `${row.id}.png`);
      drawParts(file, JSON.parse(json).parts, tools, THUMBNAIL);
    }
  }
  if (!options.check) {
    const head = '{"format":"liftarm-gallery","version":1,"models":[\n';
    writeFileSync(resolve(GALLERY, 'index.json'), `${head}${lines.join(',\n')}\n]}\n`);
  }
}

main().catch(exitWith);
