import { describe, expect, it } from 'vitest';
import { isLegalLine } from '../../../web/src/geometry/legal-line.ts';
import type { Vec3 } from '../../../web/src/geometry/vec.ts';
import { pointKey, type SketchDocument, type SketchLine } from '../../../web/src/model/sketch.ts';
import { stretch, tearOff } from '../../../web/src/state/stretch.ts';

const sketchOf = (lines: readonly SketchLine[], more: Partial<SketchDocument> = {}) =>
  ({ format: 'technic-sketch', version: 1, lines, ...more }) as SketchDocument;

const chain = (...points: Vec3[]): SketchLine[] =>
  points.slice(1).map((to, i) => ({ from: points[i] ?? to, to }));

const RECTANGLE = chain([0, 0, 0], [8, 0, 0], [8, 0, 6], [0, 0, 6], [0, 0, 0]);

/** A box of 6 by 8 by 5. */
const BOX: SketchLine[] = [
  ...[0, 6].flatMap((x) => [0, 8].map((y) => ({ from: [x, y, 0], to: [x, y, 5] }) as SketchLine)),
  ...[0, 5].flatMap((z) => [0, 8].map((y) => ({ from: [0, y, z], to: [6, y, z] }) as SketchLine)),
  ...[0, 5].flatMap((z) => [0, 6].map((x) => ({ from: [x, 0, z], to: [x, 8, z] }) as SketchLine)),
];

const ends = ({ lines }: SketchDocument) =>
  new Set(lines.flatMap(({ from, to }) => [pointKey(from), pointKey(to)]));

describe('a point that is pulled', () => {
  it('makes a frame longer, with the side that it is on', () => {
    const { sketch, changed, carried } = stretch(sketchOf(RECTANGLE), [[8, 0, 0]], [2, 0, 0]);
    expect(sketch.lines).toEqual(chain([0, 0, 0], [10, 0, 0], [10, 0, 6], [0, 0, 6], [0, 0, 0]));
    expect(changed).toEqual([0, 2]);
    expect(carried).toEqual([1]);
  });

  it('makes a frame larger both ways at once', () => {
    const { sketch } = stretch(sketchOf(RECTANGLE), [[8, 0, 6]], [1, 0, -2]);
    expect(sketch.lines).toEqual(chain([0, 0, 0], [9, 0, 0], [9, 0, 4], [0, 0, 4], [0, 0, 0]));
  });

  it('takes a whole side of a box along', () => {
    const { sketch } = stretch(sketchOf(BOX), [[6, 8, 5]], [3, 0, 0]);
    const xs = new Set(sketch.lines.flatMap(({ from, to }) => [from[0], to[0]]));
    expect(xs).toEqual(new Set([0, 9]));
    expect(ends(sketch).size).toBe(8);
  });

  it('takes along what stands on a line that goes', () => {
    const post: SketchLine = { from: [8, 0, 3], to: [8, 4, 3] };
    const { sketch } = stretch(sketchOf([...RECTANGLE, post]), [[8, 0, 6]], [2, 0, 0]);
    expect(sketch.lines[4]).toEqual({ from: [10, 0, 3], to: [10, 4, 3] });
  });

  it('leaves what stands on a line that becomes longer, and pushes what would be left behind', () => {
    const post: SketchLine = { from: [6, 0, 0], to: [6, 4, 0] };
    const sketch = sketchOf([...RECTANGLE, post]);
    expect(stretch(sketch, [[8, 0, 0]], [3, 0, 0]).sketch.lines[4]).toEqual(post);
    const shorter = stretch(sketch, [[8, 0, 0]], [-3, 0, 0]).sketch;
    for (const { from, to } of shorter.lines) {
      expect(isLegalLine(from, to)).toBe(true);
    }
    const [bottom, , , , moved] = shorter.lines;
    const xs = [bottom?.from[0] ?? 0, bottom?.to[0] ?? 0];
    expect(moved?.from[0]).toBeGreaterThanOrEqual(Math.min(...xs));
    expect(moved?.from[0]).toBeLessThanOrEqual(Math.max(...xs));
  });

  it('changes a slope to another of whole length, and else takes its other end along', () => {
    const rafters = chain([0, 0, 0], [3, 0, 4], [6, 0, 0]);
    // From 3 and 4 to 8 and 6.
    const legal = stretch(sketchOf(rafters.slice(0, 1)), [[3, 0, 4]], [5, 0, 2]).sketch;
    expect(legal.lines).toEqual(chain([0, 0, 0], [8, 0, 6]));
    const other = stretch(sketchOf(rafters), [[3, 0, 4]], [1, 0, 0]).sketch;
    expect(other.lines).toEqual(chain([1, 0, 0], [4, 0, 4], [7, 0, 0]));
  });

  it('takes joints along with their lines', () => {
    const joints = [{ at: [8, 0, 6] as Vec3, axis: [0, 1, 0] as Vec3, between: [[1], [2]] }];
    const { sketch } = stretch(sketchOf(RECTANGLE, { joints }), [[8, 0, 0]], [2, 0, 0]);
    expect(sketch.joints?.map(({ at }) => at)).toEqual([[10, 0, 6]]);
  });

  it.each([
    [1, 0, 0],
    [0, -2, 0],
    [-5, 0, 3],
    [0, 0, -5],
    [-6, 0, 0],
  ] as Vec3[])('leaves every line legal and joined: %j', (...by) => {
    const bars: SketchLine[] = [
      { from: [3, 0, 0], to: [3, 8, 0] },
      { from: [3, 4, 0], to: [3, 4, 5] },
    ];
    const before = sketchOf([...BOX, ...bars]);
    const { sketch } = stretch(before, [[6, 8, 5]], by as unknown as Vec3);
    for (const { from, to } of sketch.lines) {
      expect(isLegalLine(from, to)).toBe(true);
    }
    expect(ends(sketch).size).toBe(ends(before).size);
  });
});

describe('a line that is torn off', () => {
  it('moves its end alone', () => {
    const { lines } = tearOff(sketchOf(RECTANGLE), 0, [8, 0, 0], [2, 0, 0]);
    expect(lines[0]).toEqual({ from: [0, 0, 0], to: [10, 0, 0] });
    expect(lines.slice(1)).toEqual(RECTANGLE.slice(1));
  });

  it('moves whole where its end alone may not, and loses the joint', () => {
    const joints = [{ at: [8, 0, 0] as Vec3, axis: [0, 1, 0] as Vec3, between: [[0], [1]] }];
    const sketch = tearOff(sketchOf(RECTANGLE, { joints }), 0, [8, 0, 0], [0, 1, 0]);
    expect(sketch.lines[0]).toEqual({ from: [0, 1, 0], to: [8, 1, 0] });
    expect(sketch.joints).toBeUndefined();
  });
});
