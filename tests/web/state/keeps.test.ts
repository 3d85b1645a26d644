import { describe, expect, it } from 'vitest';
import type { KeptPart, Place } from '../../../web/src/model/keep.ts';
import type { SketchDocument } from '../../../web/src/model/sketch.ts';
import { cutStretches, mayCut } from '../../../web/src/state/cut-lines.ts';
import { applyDelta, diffSketch, invertDelta, isDelta } from '../../../web/src/state/delta.ts';
import {
  mapLines,
  quarterTurn,
  removeLines,
  shift,
  splitAt,
} from '../../../web/src/state/edits.ts';
import {
  barPart,
  freeLine,
  isKept,
  keepPart,
  releasePart,
  setLayers,
  swapPart,
  toggleSplit,
} from '../../../web/src/state/keeps.ts';
import { paintPart } from '../../../web/src/state/paint-lines.ts';
import { readSketch, writeSketch } from '../../../web/src/state/read-sketch.ts';

const SKETCH: SketchDocument = {
  format: 'technic-sketch',
  version: 1,
  lines: [
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [8, 0, 0], to: [8, 0, 6] },
    { from: [8, 0, 6], to: [0, 0, 6] },
  ],
};

function beam(line: number, part: Partial<KeptPart> = {}): Place {
  return { line, part: { part: '40490', from: 0, to: 8, layer: 0, holeAxis: 'y', ...part } };
}

const CORNER = beam(0, { part: '32526', from: 4, to: 8, with: [{ line: 1, from: 0, to: 2 }] });

describe('locks', () => {
  it('make a sketch of version 2, and one of version 1 again when they are gone', () => {
    const kept = keepPart(SKETCH, beam(0));
    expect(kept.version).toBe(2);
    expect(isKept(kept, beam(0))).toBe(true);
    expect(releasePart(kept, beam(0))).toEqual(SKETCH);
  });

  it('give way to one that lies where they are', () => {
    const kept = keepPart(keepPart(SKETCH, beam(0)), CORNER);
    expect(isKept(kept, beam(0))).toBe(false);
    expect(isKept(kept, CORNER)).toBe(true);
  });

  it('stay beside one on another layer', () => {
    const kept = keepPart(keepPart(SKETCH, beam(0)), beam(0, { layer: 1, from: 2 }));
    expect(isKept(kept, beam(0))).toBe(true);
  });

  it('read as they were written', () => {
    const kept = toggleSplit(setLayers(keepPart(SKETCH, CORNER), 2, [0, 1]), 2, 4);
    expect(readSketch(writeSketch(kept))).toEqual({ ok: true, value: kept });
  });

  it('can be undone like any edit', () => {
    const kept = keepPart(SKETCH, CORNER);
    const delta = diffSketch(SKETCH, kept);
    expect(isDelta(delta)).toBe(true);
    expect(applyDelta(SKETCH, delta)).toEqual(kept);
    expect(applyDelta(kept, invertDelta(delta))).toEqual(SKETCH);
  });

  it('swap one part for another', () => {
    const kept = swapPart(keepPart(SKETCH, beam(0)), beam(0), beam(0, { part: '32525', to: 10 }));
    expect(kept.keep).toEqual([
      { line: 0, parts: [{ part: '32525', from: 0, to: 10, layer: 0, holeAxis: 'y' }] },
    ]);
  });
});

describe('what may not lie somewhere', () => {
  it('is kept there no more', () => {
    const barred = barPart(keepPart(SKETCH, beam(0)), beam(0));
    expect(barred.keep).toEqual([{ line: 0, barred: [{ part: '40490', from: 0, to: 8 }] }]);
  });

  it('may lie there once it is locked there', () => {
    expect(keepPart(barPart(SKETCH, beam(0)), beam(0)).keep?.[0]?.barred).toBeUndefined();
  });
});

describe('rules of a line', () => {
  it('let a lock go that is on another layer', () => {
    expect(isKept(setLayers(keepPart(SKETCH, beam(0)), 0, [1, 2]), beam(0))).toBe(false);
  });

  it('are gone with the second click on a split', () => {
    expect(toggleSplit(toggleSplit(SKETCH, 0, 4), 0, 4)).toEqual(SKETCH);
  });

  it('are forgotten together', () => {
    expect(freeLine(toggleSplit(keepPart(SKETCH, beam(0)), 0, 4), 0)).toEqual(SKETCH);
  });
});

describe('an edit of the drawing', () => {
  it('gives locks the new numbers of their lines', () => {
    const kept = removeLines(keepPart(SKETCH, beam(2)), new Set([0]));
    expect(kept.keep?.[0]?.line).toBe(1);
  });

  it('drops a lock with a line that one of its bars is on', () => {
    expect(removeLines(keepPart(SKETCH, CORNER), new Set([1])).keep).toBeUndefined();
  });

  it('keeps the locks of lines that are moved', () => {
    const kept = keepPart(SKETCH, beam(0));
    expect(mapLines(kept, new Set([0, 1, 2]), shift([0, 3, 0])).keep).toEqual(kept.keep);
  });

  it('drops those of lines that are turned', () => {
    const turned = mapLines(keepPart(SKETCH, beam(0)), new Set([0]), quarterTurn('z', [0, 0, 0]));
    expect(turned.keep).toBeUndefined();
  });

  it('drops those of a line that is cut in two', () => {
    expect(splitAt(keepPart(SKETCH, beam(0)), 0, [4, 0, 0]).keep).toBeUndefined();
  });
});

describe('a part that is deleted', () => {
  it('takes its stretch out of the middle of a line', () => {
    const { lines } = cutStretches(SKETCH, [{ line: 0, from: 2, to: 6 }]);
    expect(lines[0]).toEqual({ from: [0, 0, 0], to: [2, 0, 0] });
    expect(lines[3]).toEqual({ from: [6, 0, 0], to: [8, 0, 0] });
  });

  it('takes a whole line with it', () => {
    expect(cutStretches(SKETCH, [{ line: 0, from: -1, to: 8 }]).lines).toHaveLength(2);
  });

  it('may not be the last', () => {
    const one = { ...SKETCH, lines: SKETCH.lines.slice(0, 1) };
    expect(mayCut(one, [{ line: 0, from: 0, to: 8 }])).toBe(false);
    expect(mayCut(one, [{ line: 0, from: 0, to: 5 }])).toBe(true);
  });
});

it('a part has a colour of its own until it is taken away', () => {
  const part = { part: '2780', at: [1, 2, 3] as const };
  const painted = paintPart(paintPart(SKETCH, part, 4), part, 14);
  expect(painted.colours?.parts).toEqual([{ ...part, colour: 14 }]);
  expect(paintPart(painted, part, null)).toEqual(SKETCH);
});
