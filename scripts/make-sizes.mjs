// Writes web/src/model/known-sizes.json: names and boxes of parts that files of others hold and the catalogue does not,
// so that they can be shown and named. Technic parts from the facts in ../shared/parts/technic_parts.json (NOTICE names
// their sources), bricks and plates from their count of studs. Run it after a change of the catalogue:
// node scripts/make-sizes.mjs [--check]
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { STUDDED } from './lib/studded-parts.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '..');
const read = (path) => JSON.parse(readFileSync(join(root, path), 'utf8'));
const target = join(root, 'web/src/model/known-sizes.json');

const LDU_PER_MODULE = 20;
const HEIGHTS = { Brick: 24, Plate: 8, Tile: 8 };

/** LDraw (x, y, z) in LDU is (x, z, -y) in modules. */
function box([[x0, y0, z0], [x1, y1, z1]]) {
  return [x0, z0, -y1, x1, z1, -y0].map((v) => Math.round((v / LDU_PER_MODULE) * 100) / 100 + 0);
}

const known = new Set(read('core/parts/catalogue.json').parts.map(({ id }) => id));
const technic = Object.entries(read('../shared/parts/technic_parts.json').parts).map(
  ([id, { title, bbox }]) => [id, [title, ...box(bbox)]],
);
const studded = STUDDED.map(([id, kind, long, wide]) => {
  const [x, z] = [long * 10, wide * 10];
  const corners = [
    [-x, 0, -z],
    [x, HEIGHTS[kind], z],
  ];
  return [id, [`${kind} ${wide} x ${long}`, ...box(corners)]];
});
const rows = [...technic, ...studded]
  .filter(([id]) => !known.has(id))
  .sort(([a], [b]) => (a < b ? -1 : 1))
  .map(([id, row]) => `${JSON.stringify(id)}:${JSON.stringify(row)}`);
const text = `{\n${rows.join(',\n')}\n}\n`;
if (process.argv.includes('--check')) {
  if (readFileSync(target, 'utf8') !== text) {
    console.error('web/src/model/known-sizes.json is not what scripts/make-sizes.mjs writes');
    process.exitCode = 1;
  }
} else {
  writeFileSync(target, text);
}
