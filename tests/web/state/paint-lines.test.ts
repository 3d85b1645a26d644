import { describe, expect, it } from 'vitest';
import type { SketchDocument } from '../../../web/src/model/sketch.ts';
import { applyDelta, diffSketch, invertDelta, isDelta } from '../../../web/src/state/delta.ts';
import { removeLines, splitAt } from '../../../web/src/state/edits.ts';
import { paintLines, setBeamColour, setScheme } from '../../../web/src/state/paint-lines.ts';
import { readSketch, writeSketch } from '../../../web/src/state/read-sketch.ts';

const SKETCH: SketchDocument = {
  format: 'technic-sketch',
  version: 1,
  lines: [
    { from: [0, 0, 0], to: [4, 0, 0] },
    { from: [4, 0, 0], to: [4, 4, 0] },
    { from: [4, 4, 0], to: [0, 4, 0] },
  ],
};
const PAINTED = paintLines(SKETCH, new Set([1, 2]), 14);

describe('colours of a sketch', () => {
  it('make it one of version 2, and without any it is one of version 1 again', () => {
    expect(PAINTED).toMatchObject({ version: 2, colours: { lines: { 1: 14, 2: 14 } } });
    expect(paintLines(PAINTED, new Set([1, 2]), null)).toEqual(SKETCH);
  });

  it('are read back from the file', () => {
    const read = readSketch(writeSketch(PAINTED));
    expect(read.ok && read.value).toEqual(PAINTED);
  });

  it('are undone and done again', () => {
    const delta = diffSketch(SKETCH, PAINTED);
    expect(applyDelta(SKETCH, delta)).toEqual(PAINTED);
    expect(isDelta(delta) && isDelta(invertDelta(delta))).toBe(true);
    expect(applyDelta(PAINTED, invertDelta(delta))).toEqual(SKETCH);
  });

  it('go with their lines when others are removed', () => {
    expect(removeLines(PAINTED, new Set([1])).colours?.lines).toEqual({ 1: 14 });
  });

  it('are those of both halves of a line', () => {
    expect(splitAt(PAINTED, 1, [4, 2, 0]).colours?.lines).toEqual({ 1: 14, 2: 14, 3: 14 });
  });

  it('have a scheme or one colour for all beams', () => {
    const one = setBeamColour(setScheme(SKETCH, 'component'), 4);
    expect(one.colours).toEqual({ default: 4 });
    expect(setScheme(one, 'usual').colours).toEqual({ scheme: 'usual' });
    expect(setScheme(one, null)).toEqual(SKETCH);
  });

  it.each([
    ['colours: should be an object', 3],
    ['colours.scheme: should be one of length, component, usual', { scheme: 'pink' }],
    ['colours.default: should be an LDraw code from 0 to 511', { default: 16 }],
    ['colours.kinds: brick is not known', { kinds: { brick: 4 } }],
    ['colours.lines: 3 is not known', { lines: { 3: 4 } }],
    ['colours.lines.1: should be an LDraw code from 0 to 511', { lines: { 1: 0.5 } }],
  ])('are refused by their place: %s', (message, colours) => {
    const read = readSketch(JSON.stringify({ ...SKETCH, version: 2, colours }));
    expect(read).toEqual({ ok: false, message });
  });
});
