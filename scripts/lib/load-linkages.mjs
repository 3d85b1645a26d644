import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { TOP } from './run.mjs';

/** The table of linkages of the module that the page ships, in Node. Needs build/wasm. */
export async function loadLinkages() {
  const folder = resolve(TOP, 'build/wasm');
  const { default: create } = await import(pathToFileURL(join(folder, 'liftarm-linkages.js')).href);
  const module = await create({
    wasmBinary: readFileSync(join(folder, 'liftarm-linkages.wasm')),
  });
  const table = new module.LinkageTable();
  while (!table.advance(100)) {
    // On to the next couplers.
  }
  return table;
}
