import { resolve } from 'node:path';
import { defineConfig } from 'vitest/config';
import { contentPolicy, serviceWorker, solverPreload } from './pwa/build-plugin.ts';

const root = import.meta.dirname;
const top = resolve(root, '..');
const outDir = resolve(top, process.env['LIFTARM_DIST'] ?? 'dist');
const wasm = resolve(top, process.env['LIFTARM_WASM'] ?? 'build/wasm');

// Vitest reads the same file (field `test`).
export default defineConfig({
  root,
  // Relative addresses: the built page works under any path of a plain static server.
  base: './',
  publicDir: resolve(top, 'public'),
  cacheDir: resolve(top, 'node_modules/.vite'),
  resolve: { alias: { '@wasm': wasm } },
  worker: { format: 'es' },
  plugins: [contentPolicy(), solverPreload(), serviceWorker(() => outDir)],
  server: { fs: { allow: [top] } },
  build: {
    // three.js alone is more than the default of 500 kB; e2e holds a budget for the whole page.
    chunkSizeWarningLimit: 1200,
    rolldownOptions: {
      checks: { pluginTimings: false },
      // glTF-Transform asks for node:fs in what it does in Node alone.
      onLog: (level, log, handle) => {
        if (!/externalized .*@gltf-transform/s.test(log.message)) {
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
    testTimeout: 60_000,
  },
});
