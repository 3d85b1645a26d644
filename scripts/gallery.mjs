// `npm run gallery [-- --only IDS] [--check]`: solves every model of the gallery, or those named, writes its figures into
// public/gallery/index.json and draws its thumbnail with the page's own renderer. Ends with 1 when a
// model is not buildable. A row with `"made": true` is a large one: its model is written into public/gallery/made,
// so that the page opens it without a search. `--check` compares only, and writes nothing. Needs build/wasm.
import { mkdirSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { drawParts, GALLERY, openGallery, writeMade } from './lib/gallery.mjs';
import { exitWith, StepError } from './lib/run.mjs';

/** Thin lines: a thumbnail is small. */
const THUMBNAIL = {
  size: { width: 320, height: 240, margin: 12 },
  colours: 64,
  style: { detail: 'high', smooth: 3, line: 0.34 },
};

const { values: options } = parseArgs({
  options: { check: { type: 'boolean', default: false }, only: { type: 'string' } },
});

async function main() {
  const { tools, all, rows, solve } = await openGallery(options.only);
  for (const folder of ['thumbs', 'made']) {
    mkdirSync(resolve(GALLERY, folder), { recursive: true });
  }
  const figuresOf = new Map();
  for (const row of rows) {
    const { report, json, gears, made } = solve(row);
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
    figuresOf.set(row.id, figures);
    if (!options.check) {
      const file = resolve(GALLERY, 'thumbs', `${row.id}.png`);
      drawParts(file, JSON.parse(json).parts, tools, THUMBNAIL);
      if (made) {
        writeMade(resolve(GALLERY, `made/${row.id}.made`), made);
      }
    }
  }
  if (!options.check) {
    const head = '{"format":"liftarm-gallery","version":1,"models":[\n';
    const lines = all.map((row) => JSON.stringify({ ...row, ...figuresOf.get(row.id) }));
    writeFileSync(resolve(GALLERY, 'index.json'), `${head}${lines.join(',\n')}\n]}\n`);
  }
}

main().catch(exitWith);
