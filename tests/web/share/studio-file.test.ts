import { Uint8ArrayReader, Uint8ArrayWriter, ZipWriter } from '@zip.js/zip.js';
import { describe, expect, it } from 'vitest';
import { looksLikeArchive, modelInArchive } from '../../../web/src/share/studio-file.ts';

const BEAM = '1 71 0 0 0 1 0 0 0 1 0 0 0 1 32316.dat\n';

async function archive(
  files: Readonly<Record<string, string>>,
  password?: string,
): Promise<Uint8Array<ArrayBuffer>> {
  const locked = password === undefined ? {} : { password, zipCrypto: true };
  const zip = new ZipWriter(new Uint8ArrayWriter(), { ...locked, useWebWorkers: false });
  for (const [name, text] of Object.entries(files)) {
    await zip.add(name, new Uint8ArrayReader(new TextEncoder().encode(text)));
  }
  return new Uint8Array(await zip.close());
}

async function opened(bytes: Uint8Array<ArrayBuffer>): Promise<string> {
  const model = await modelInArchive(bytes);
  return model.ok ? new TextDecoder().decode(model.value) : model.message;
}

describe('Studio files', () => {
  const files = { 'thumbnail.png': 'x', 'model2.ldr': '0 old\n', 'model.ldr': BEAM };

  it('give the model in them', async () => {
    const bytes = await archive(files);
    expect(looksLikeArchive(bytes)).toBe(true);
    expect(await opened(bytes)).toBe(BEAM);
  });

  it('open with the password that all of them have', async () => {
    expect(await opened(await archive(files, 'soho0909'))).toBe(BEAM);
  });

  it('say that another password is not known', async () => {
    expect(await opened(await archive(files, 'another'))).toContain('password');
  });

  it('say that there is no model in them', async () => {
    expect(await opened(await archive({ 'a.txt': BEAM }))).toContain('holds no model');
  });

  it('say that they are damaged', async () => {
    const bytes = await archive(files);
    expect(await opened(bytes.slice(0, bytes.length / 2))).toContain('damaged');
  });
});
