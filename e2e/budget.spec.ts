import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { expect, test } from '@playwright/test';

const ASSETS = resolve(import.meta.dirname, '../dist/assets');

/** Kilobytes that a visitor loads for one kind of file, compressed as static hosts do. */
function compressedKilobytes(ending: string): number {
  return readdirSync(ASSETS)
    .filter((name) => name.endsWith(ending))
    .map((name) => gzipSync(readFileSync(join(ASSETS, name))).length / 1000)
    .reduce((sum, size) => sum + size, 0);
}

// Somewhat above what there is: a new dependency or a careless include must show.
test('scripts stay within their budget', () => {
  expect(compressedKilobytes('.js')).toBeLessThan(350);
});

test('the WebAssembly module stays within its budget', () => {
  expect(compressedKilobytes('.wasm')).toBeLessThan(350);
});
