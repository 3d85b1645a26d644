import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build } from 'vite';
import { TOP } from './run.mjs';

/** Bundles a TypeScript module for Node and imports it: Node 20 does not read TypeScript itself. */
export async function loadTypeScript(path) {
  const result = await build({
    configFile: false,
    root: TOP,
    logLevel: 'error',
    build: { ssr: resolve(TOP, path), write: false, target: 'node20' },
    ssr: { noExternal: true },
  });
  const output = Array.isArray(result) ? result[0].output : result.output;
  const file = resolve(TOP, 'build/scripts', `${path.replace(/[^\w]+/g, '-')}.mjs`);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, output[0].code);
  return import(pathToFileURL(file).href);
}
