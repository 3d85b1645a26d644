import { existsSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { READERS } from './readers.ts';

// What the fuzzer has found worth keeping, over again: every place in the readers that it reached.

const FOLDER = resolve(import.meta.dirname, '../../fuzz/corpora');

describe.each(Object.entries(READERS))('the reader %s', (name, read) => {
  it('answers to every kept input', async () => {
    const file = resolve(FOLDER, `${name}.json`);
    const kept = existsSync(file) ? (JSON.parse(readFileSync(file, 'utf8')) as string[]) : [];
    expect(kept.length).toBeGreaterThan(0);
    for (const text of kept) {
      await read(new Uint8Array(Buffer.from(text, 'base64')));
    }
  });
});
