// `npm run package`: the npm package (engine, workers, types) in build/package, from build/wasm and web/src/package.
import { copyFileSync, cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'vite';
import { build as buildPart } from './build.mjs';
import { exitWith, localBin, run, TOP, timed } from './lib/run.mjs';
import { setUp } from './setup.mjs';

const SOURCE = join(TOP, 'web/src/package');
const WASM = join(TOP, 'build/wasm');
export const PACKAGE = join(TOP, 'build/package');

/** The files of the package by what they are made from; each holds all that it needs but the module. */
const BUNDLES = {
  'index.js': 'browser.ts',
  'worker.js': 'browser-worker.ts',
  'node.js': 'node.ts',
  'node-worker.js': 'node-worker.ts',
};

function bundle(file, entry) {
  return build({
    root: TOP,
    configFile: false,
    logLevel: 'warn',
    resolve: { alias: { '@wasm': WASM } },
    build: {
      outDir: PACKAGE,
      emptyOutDir: false,
      copyPublicDir: false,
      target: 'es2022',
      lib: { entry: join(SOURCE, entry), formats: ['es'], fileName: () => file },
      rolldownOptions: {
        external: /^node:/,
        platform: 'neutral',
        checks: { pluginTimings: false },
      },
    },
  });
}

/** What npm is told; the version is the project's own. */
function manifest() {
  const { version, description, license, engines } = JSON.parse(
    readFileSync(join(TOP, 'package.json'), 'utf8'),
  );
  return {
    name: 'liftarm',
    version,
    description,
    license,
    type: 'module',
    engines,
    sideEffects: false,
    types: './types/package/browser.d.ts',
    exports: {
      '.': {
        types: './types/package/browser.d.ts',
        node: './node.js',
        default: './index.js',
      },
      './liftarm-core.wasm': './liftarm-core.wasm',
      './schemas/*': './schemas/*',
    },
  };
}

/** Makes the package anew. Needs build/wasm. */
export async function makePackage() {
  rmSync(PACKAGE, { recursive: true, force: true });
  mkdirSync(PACKAGE, { recursive: true });
  for (const [file, entry] of Object.entries(BUNDLES)) {
    await bundle(file, entry);
  }
  await run(localBin('tsc'), ['-p', join(SOURCE, 'tsconfig.json')]);
  copyFileSync(join(WASM, 'liftarm-core.wasm'), join(PACKAGE, 'liftarm-core.wasm'));
  for (const file of ['LICENSE', 'NOTICE']) {
    copyFileSync(join(TOP, file), join(PACKAGE, file));
  }
  cpSync(join(TOP, 'licences'), join(PACKAGE, 'licences'), { recursive: true });
  cpSync(join(TOP, 'docs/schemas'), join(PACKAGE, 'schemas'), { recursive: true });
  copyFileSync(join(TOP, 'docs/examples/js/README.md'), join(PACKAGE, 'README.md'));
  writeFileSync(join(PACKAGE, 'package.json'), `${JSON.stringify(manifest(), null, 2)}\n`);
}

async function main() {
  await setUp({ forTests: false });
  await timed('build wasm', () => buildPart('wasm'));
  await timed('package', makePackage);
}

if (process.argv[1] === import.meta.filename) {
  main().catch(exitWith);
}
