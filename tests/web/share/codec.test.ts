import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { SketchDocument } from '../../../web/src/model/sketch.ts';
import { decodeShare, encodeShare, MAX_FRAGMENT } from '../../../web/src/share/codec.ts';

const SKETCH: SketchDocument = {
  format: 'technic-sketch',
  version: 1,
  name: 'Wippe “ä” 🙂',
  lines: [
    { from: [0, 0, 0], to: [6, 0, 0] },
    { from: [3, 0, 0], to: [3, 0, 5], exact: true, holeAxis: 'y' },
    { from: [0, 0, 0], to: [2, 3.464102, 0], holeAxis: 'z' },
  ],
  joints: [{ at: [3, 0, 0], axis: [0, 1, 0], between: [[0], [1]] }],
  keepOut: [{ min: [0, 0, 1], max: [2, 2, 2] }],
  symmetries: [{ kind: 'reflection', normal: [1, 0, 0], offset: 3 }],
  ground: -1,
};
const STATE = { sketch: SKETCH, preset: 'faithful', seed: 7 };
/** Everything that version 2 added. */
const STATE_2 = {
  ...STATE,
  sketch: {
    ...SKETCH,
    symmetries: [
      ...(SKETCH.symmetries ?? []),
      { kind: 'translation', vector: [0, 4, 0], pairs: [[0, 1]] } as const,
    ],
  },
  settings: { effort: 2, off: ['55615'], owned: { 2780: 40 }, advanced: 'corners=false' },
};

/** And what version 3 added. */
const STATE_3 = {
  ...STATE_2,
  sketch: {
    ...STATE_2.sketch,
    version: 2 as const,
    colours: { scheme: 'component', kinds: { pin: 4 }, lines: { 1: 14 } } as const,
  },
};

/** And what version 4 added. */
const STATE_4 = {
  ...STATE_3,
  sketch: {
    ...STATE_3.sketch,
    joints: [
      { at: [3, 0, 0], axis: [0, 1, 0], between: [[0], [1]], range: [-180, 180] },
      { at: [3, 0, 0], axis: [1, 0, 0] },
    ],
  } satisfies SketchDocument,
};

/** And what version 5 added. */
const STATE_5 = {
  ...STATE_4,
  sketch: {
    ...STATE_4.sketch,
    colours: { ...STATE_4.sketch.colours, parts: [{ part: '32524', at: [3, 1, 0], colour: 2 }] },
    keep: [
      {
        line: 0,
        parts: [{ part: '32524', from: 0, to: 6, layer: 1, holeAxis: 'y' }],
        splits: [3],
      },
      { line: 1, barred: [{ part: '40490', from: -1, to: 7 }], layers: [0] },
    ],
  } satisfies SketchDocument,
};

/** And what version 6 added. */
const STATE_6 = {
  ...STATE_5,
  sketch: {
    ...STATE_5.sketch,
    shafts: [
      { from: [1, -1, 0], to: [1, 5, 0] },
      { from: [4, -1, 0], to: [4, 5, 0] },
    ],
    drives: [
      { from: 0, to: 1, ratio: 5 },
      { from: 1, to: 0, ratio: 0.2, tolerance: 1 },
    ],
  } satisfies SketchDocument,
};

async function fragment(): Promise<string> {
  const encoded = await encodeShare(STATE);
  return encoded.ok ? encoded.value : '';
}

describe('share link', () => {
  it('comes back as it was', async () => {
    expect(await decodeShare(await fragment())).toEqual({ ok: true, value: STATE });
  });

  it('reads the links of version 1 for ever', async () => {
    const path = new URL('./fixtures/v1-seesaw.txt', import.meta.url);
    const read = await decodeShare(readFileSync(path, 'utf8').trim());
    expect(read).toEqual({ ok: true, value: STATE });
  });

  it('holds the ranges of joints, with colours and without', async () => {
    const { colours: _, ...plain } = STATE_4.sketch;
    for (const state of [STATE_4, { ...STATE_4, sketch: plain }]) {
      const encoded = await encodeShare(state);
      expect(encoded.ok && encoded.value.startsWith('s4.')).toBe(true);
      expect(await decodeShare(encoded.ok ? encoded.value : '')).toEqual({
        ok: true,
        value: state,
      });
    }
  });

  it('reads the links of version 4 for ever', async () => {
    const path = new URL('./fixtures/v4-seesaw.txt', import.meta.url);
    const read = await decodeShare(readFileSync(path, 'utf8').trim());
    expect(read).toEqual({ ok: true, value: STATE_4 });
  });

  it('holds what is kept of the model, and colours of single parts', async () => {
    const encoded = await encodeShare(STATE_5);
    expect(encoded.ok && encoded.value.startsWith('s5.')).toBe(true);
    const read = await decodeShare(encoded.ok ? encoded.value : '');
    expect(read).toEqual({ ok: true, value: STATE_5 });
  });

  it('reads the links of version 5 for ever', async () => {
    const path = new URL('./fixtures/v5-seesaw.txt', import.meta.url);
    const read = await decodeShare(readFileSync(path, 'utf8').trim());
    expect(read).toEqual({ ok: true, value: STATE_5 });
  });

  it('holds shafts and what couples them', async () => {
    const encoded = await encodeShare(STATE_6);
    expect(encoded.ok && encoded.value.startsWith('s6.')).toBe(true);
    const read = await decodeShare(encoded.ok ? encoded.value : '');
    expect(read).toEqual({ ok: true, value: STATE_6 });
  });

  it('reads the links of version 6 for ever', async () => {
    const path = new URL('./fixtures/v6-seesaw.txt', import.meta.url);
    const read = await decodeShare(readFileSync(path, 'utf8').trim());
    expect(read).toEqual({ ok: true, value: STATE_6 });
  });

  it('holds what sits at the ends of shafts', async () => {
    const shafts = [
      { from: [1, -1, 0], to: [1, 5, 0], atTo: 'wheel' },
      { from: [4, -1, 0], to: [4, 5, 0], atFrom: 'crank', atTo: 'wheel' },
    ] as const;
    const state = { ...STATE_6, sketch: { ...STATE_6.sketch, shafts } };
    const encoded = await encodeShare(state);
    const read = await decodeShare(encoded.ok ? encoded.value : '');
    expect(read).toEqual({ ok: true, value: state });
  });

  it('is refused where a drive couples what is no shaft', async () => {
    const drives = [{ from: 0, to: 7, ratio: 5 }];
    const encoded = await encodeShare({ ...STATE_6, sketch: { ...STATE_6.sketch, drives } });
    const read = await decodeShare(encoded.ok ? encoded.value : '');
    expect(read?.ok).toBe(false);
  });

  it('holds settings and symmetries of both kinds', async () => {
    const encoded = await encodeShare(STATE_2);
    const read = await decodeShare(encoded.ok ? encoded.value : '');
    expect(read).toEqual({ ok: true, value: STATE_2 });
  });

  it('reads the links of version 2 for ever', async () => {
    const path = new URL('./fixtures/v2-seesaw.txt', import.meta.url);
    const read = await decodeShare(readFileSync(path, 'utf8').trim());
    expect(read).toEqual({ ok: true, value: STATE_2 });
  });

  it('holds colours', async () => {
    const encoded = await encodeShare(STATE_3);
    const read = await decodeShare(encoded.ok ? encoded.value : '');
    expect(read).toEqual({ ok: true, value: STATE_3 });
  });

  it('reads the links of version 3 for ever', async () => {
    const path = new URL('./fixtures/v3-seesaw.txt', import.meta.url);
    const read = await decodeShare(readFileSync(path, 'utf8').trim());
    expect(read).toEqual({ ok: true, value: STATE_3 });
  });

  it('leaves a fragment alone that is not its own', async () => {
    expect(await decodeShare('')).toBeNull();
    expect(await decodeShare('chapter-2')).toBeNull();
  });

  it('says that a newer page made the link', async () => {
    const read = await decodeShare((await fragment()).replace(/^s2/, 's9'));
    expect(read?.ok === false && read.message).toContain('newer version');
  });

  it.each([
    ['cut off', (text: string) => text.slice(0, -9)],
    ['changed', (text: string) => text.replace(/.(.{12})$/, '_$1')],
    ['without its sum', (text: string) => text.replace(/\.[^.]*$/, '')],
    ['of garbage', () => 's1.!!!!.0'],
    ['of nothing', () => 's1..'],
    ['too long', () => `s1.${'A'.repeat(MAX_FRAGMENT)}.0`],
  ])('refuses a link that is %s', async (_name, damage) => {
    const read = await decodeShare(damage(await fragment()));
    expect(read?.ok).toBe(false);
  });

  it('refuses a sketch that no link can hold', async () => {
    const lines = Array.from({ length: 6000 }, (_, i) => ({
      from: [0, i % 100, i] as const,
      to: [3, i % 100, i] as const,
    }));
    expect((await encodeShare({ ...STATE, sketch: { ...SKETCH, lines } })).ok).toBe(false);
  });
});
