import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../../web/src/geometry/vec.ts';
import type { SketchDocument, SketchLine } from '../../../web/src/model/sketch.ts';
import { freerEnd, lengthStep, setLength } from '../../../web/src/state/line-length.ts';

const sketchOf = (lines: readonly SketchLine[]): SketchDocument => ({
  format: 'technic-sketch',
  version: 1,
  lines,
});

const chain = (...points: Vec3[]): SketchLine[] =>
  points.slice(1).map((to, i) => ({ from: points[i] ?? to, to }));

const RECTANGLE = chain([0, 0, 0], [8, 0, 0], [8, 0, 6], [0, 0, 6], [0, 0, 0]);

describe('the length of a line', () => {
  it('moves the end that is named, with the side that hangs on it', () => {
    const right = setLength(sketchOf(RECTANGLE), 0, { end: 'to', length: 10 });
    expect(right.ok && right.sketch.lines).toEqual(
      chain([0, 0, 0], [10, 0, 0], [10, 0, 6], [0, 0, 6], [0, 0, 0]),
    );
    const left = setLength(sketchOf(RECTANGLE), 0, { end: 'from', length: 10 });
    expect(left.ok && left.sketch.lines).toEqual(
      chain([-2, 0, 0], [8, 0, 0], [8, 0, 6], [-2, 0, 6], [-2, 0, 0]),
    );
  });

  it('keeps a slanted line on whole modules', () => {
    const [slanted] = chain([0, 0, 0], [3, 0, 4]);
    expect(slanted && lengthStep(slanted)).toBe(5);
    const sketch = sketchOf(chain([0, 0, 0], [3, 0, 4]));
    expect(setLength(sketch, 0, { end: 'to', length: 7 })).toEqual({
      ok: false,
      refusal: { why: 'step', step: 5 },
    });
    const longer = setLength(sketch, 0, { end: 'from', length: 10 });
    expect(longer.ok && longer.sketch.lines).toEqual(chain([-3, 0, -4], [3, 0, 4]));
  });

  it('is any whole one where the line leaves the lattice anyway', () => {
    const sixty: SketchLine = { from: [0, 0, 0], to: [2, 0, 2 * Math.sqrt(3)] };
    const longer = setLength(sketchOf([sixty]), 0, { end: 'to', length: 5 });
    expect(longer.ok && longer.sketch.lines[0]?.to[0]).toBeCloseTo(2.5);
  });

  it('is refused where something stands on what would go', () => {
    const sketch = sketchOf([
      { from: [0, 0, 0], to: [8, 0, 0] },
      { from: [6, 0, 0], to: [6, 0, 4] },
    ]);
    expect(setLength(sketch, 0, { end: 'to', length: 5 })).toEqual({
      ok: false,
      refusal: { why: 'held' },
    });
  });

  it('is a whole number from 1 on', () => {
    for (const length of [0, -3, 2.5, Number.NaN, 5000]) {
      expect(setLength(sketchOf(RECTANGLE), 0, { end: 'to', length })).toEqual({
        ok: false,
        refusal: { why: 'whole' },
      });
    }
  });

  it('moves the end on which less hangs, unless told otherwise', () => {
    const [first, second] = chain([0, 0, 0], [8, 0, 0], [8, 0, 6]);
    const sketch = sketchOf([first, second].flatMap((line) => line ?? []));
    expect(freerEnd(sketch, 0)).toBe('from');
    expect(freerEnd(sketch, 1)).toBe('to');
  });
});
