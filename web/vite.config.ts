import { resolve } from 'node:path';
import { defineConfig } from 'vitest/config';
import { contentPolicy, serviceWorker } from './pwa/build-plugin.ts';
import { firstModel } from './pwa/first-model-plugin.ts';
import { licences } from './pwa/licences-plugin.ts';

const root = import.meta.dirname;
const top = resolve(root, '..');
const outDir = resolve(top, process.env['LIFTARM_DIST'] ?? 'dist');
const publicDir = resolve(top, 'public');
const wasm = resolve(top, process.env['LIFTARM_WASM'] ?? 'build/wasm');

const shipped = licences({ top });

// Vitest reads the same file (field `test`).
export default defineConfig({
  root,
  // Relative addresses: the built page works under any path of a plain static server.
  base: './',
  publicDir,
  cacheDir: resolve(top, 'node_modules/.vite'),
  resolve: { alias: { '@wasm': wasm } },
  worker: { format: 'es', plugins: () => [shipped.worker] },
  plugins: [
    contentPolicy(),
    firstModel({ wasm, public: publicDir }),
    shipped.page,
    serviceWorker(() => outDir),
  ],
  server: { fs: { allow: [top] } },
  build: {
    // three.js alone is more than the default of 500 kB; e2e holds a budget for the whole page.
    chunkSizeWarningLimit: 1200,
    rolldownOptions: {
      output: {
        // Two files in place of twenty small ones, each of which would wait for its turn on the line.
        codeSplitting: {
          groups: [
            { name: 'three', test: /[\\/]node_modules[\\/]three[\\/]/, tags: ['$initial'] },
            { name: 'base', tags: ['$initial'], minShareCount: 2 },
          ],
        },
      },
      checks: { pluginTimings: false },
      // glTF-Transform asks for node:fs in what it does in Node alone, and HiGHS for node:module.
      onLog: (level, log, handle) => {
        if (!/externalized .*(?:@gltf-transform|\/highs\/)/s.test(log.message)) {
          handle(level, log);
        }
      },
      input: { index: resolve(root, 'index.html'), embed: resolve(root, 'embed.html') },
    },
    outDir,
    emptyOutDir: true,
    target: 'es2022',
    sourcemap: true,
  },
  test: {
    root: top,
    include: [
      'tests/web/**/*.test.{ts,tsx}',
      'tests/contract/**/*.test.{ts,mjs}',
      'tests/checks/**/*.test.mjs',
    ],
    environment: 'node',
    // Node starts threads quicker than processes: the whole run takes half as long.
    pool: 'threads',
    // Its own choice leaves one core of two idle.
    maxWorkers: '100%',
    testTimeout: 240_000,
  },
});
