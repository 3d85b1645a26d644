import { execFileSync } from 'node:child_process';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { crc32, zipOf } from '../../../web/src/ui/share/zip.ts';

const bytes = (text: string) => new TextEncoder().encode(text);

/** Reads an archive with Python's own reader, which checks sums and headers. */
const READER = `
import json, sys, zipfile
with zipfile.ZipFile(sys.argv[1]) as archive:
    print(json.dumps([archive.testzip(), [[f, archive.read(f).decode()] for f in archive.namelist()]]))
`;

async function readBack(archive: Blob): Promise<unknown> {
  const file = join(mkdtempSync(join(tmpdir(), 'liftarm-zip-')), 'a.zip');
  writeFileSync(file, new Uint8Array(await archive.arrayBuffer()));
  return JSON.parse(execFileSync('python3', ['-c', READER, file], { encoding: 'utf8' }));
}

describe('archives', () => {
  it('are read by another program, entry by entry', async () => {
    const entries = [
      ['frame-0001.png', 'first'],
      ['frame-0002.png', ''],
      ['folder/note.txt', 'x'.repeat(70_000)],
    ] as const;
    const archive = zipOf(entries.map(([name, text]) => ({ name, content: bytes(text) })));
    expect(await readBack(archive)).toEqual([null, entries]);
  });

  it('may be empty', async () => {
    expect(await readBack(zipOf([]))).toEqual([null, []]);
  });

  it('have the check sum of the format', () => {
    expect(crc32(bytes('123456789'))).toBe(0xcbf43926);
    expect(crc32(bytes(''))).toBe(0);
  });
});
