// `npm run gallery:stl [-- --only ID,ID]`: writes every gallery model as STL into build/stl/ and lets ADMesh,
// which compares corners exactly, look for what it would have to mend. Ends with 1 when there is anything.
// Needs admesh and build/wasm.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { mendsOf } from './lib/admesh.mjs';
import { openGallery } from './lib/gallery.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';

const { values: options } = parseArgs({
  options: {
    out: { type: 'string', default: resolve(TOP, 'build/stl') },
    only: { type: 'string' },
  },
});

async function main() {
  const { tools, rows, solve } = await openGallery(options.only);
  mkdirSync(options.out, { recursive: true });
  const faults = [];
  for (const row of rows) {
    const { name, parts } = JSON.parse(solve(row).json);
    const path = join(options.out, `${row.id}.stl`);
    const file = tools.writeStl({ name, parts }, tools.shelf);
    writeFileSync(path, file);
    const mends = mendsOf(path);
    console.log(`${row.id.padEnd(16)} ${parts.length} parts, ${mends.length} things to mend`);
    faults.push(...mends.map((mend) => `${row.id}: ${mend}`));
  }
  if (faults.length > 0) {
    throw new StepError(faults.join('\n'));
  }
}

main().catch(exitWith);
