import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { TOP } from './run.mjs';

/** The module that the page ships, in Node. Needs build/wasm. */
export async function loadCore() {
  const folder = resolve(TOP, 'build/wasm');
  const { default: create } = await import(pathToFileURL(join(folder, 'liftarm-core.js')).href);
  return create({ wasmBinary: readFileSync(join(folder, 'liftarm-core.wasm')) });
}
