import { deflateRawSync } from 'node:zlib';
import { expect, it } from 'vitest';
import { unpackMade } from '../../../web/src/solver/made-file.ts';

const MADE = {
  settings: { seed: 1, preset: 'balanced', set: {} },
  modelJson: '{}',
  reportJson: '{}',
  checkJson: '{}',
};

function packed(value: unknown): ArrayBuffer {
  return new Uint8Array(deflateRawSync(JSON.stringify(value))).buffer;
}

it('a model comes out of its file as it was written', async () => {
  expect(await unpackMade(packed(MADE))).toEqual(MADE);
});

it.each(['modelJson', 'reportJson', 'checkJson', 'settings'])(
  'a file without %s is refused',
  async (key) => {
    const rest = Object.fromEntries(Object.entries(MADE).filter(([other]) => other !== key));
    await expect(unpackMade(packed(rest))).rejects.toThrow('unreadable');
  },
);

it('bytes that are no such file are refused', async () => {
  await expect(unpackMade(new Uint8Array([1, 2, 3]).buffer)).rejects.toThrow();
});
