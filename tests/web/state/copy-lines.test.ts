import { describe, expect, it } from 'vitest';
import type { SketchDocument, SketchJoint, SketchLine } from '../../../web/src/model/sketch.ts';
import { copyLines } from '../../../web/src/state/copy-lines.ts';
import { mirrorAt, shift } from '../../../web/src/state/edits.ts';
import { isOffset, offsetImages, offsetLines } from '../../../web/src/state/offset-lines.ts';

const sketchOf = (lines: readonly SketchLine[], more: Partial<SketchDocument> = {}) =>
  ({ format: 'technic-sketch', version: 1, lines, ...more }) as SketchDocument;

/** A post, an arm on its top that turns, and a foot. */
const CRANE: SketchLine[] = [
  { from: [0, 0, 0], to: [0, 0, 6] },
  { from: [0, 0, 6], to: [5, 0, 6] },
  { from: [0, 0, 0], to: [3, 0, 0] },
];
const JOINT: SketchJoint = { at: [0, 0, 6], axis: [0, 1, 0] };
const BOTH = new Set([0, 1]);

describe('copies of lines', () => {
  it('have the joints of which all lines are copied', () => {
    const { sketch, added } = copyLines(sketchOf(CRANE, { joints: [JOINT] }), BOTH, [
      shift([0, 4, 0]),
    ]);
    expect(added).toEqual([3, 4]);
    expect(sketch.joints).toEqual([JOINT, { at: [0, 4, 6], axis: [0, 1, 0] }]);
  });

  it('have no joint of which a line is missing', () => {
    const { sketch } = copyLines(sketchOf(CRANE, { joints: [JOINT] }), new Set([1]), [
      shift([0, 4, 0]),
    ]);
    expect(sketch.joints).toEqual([JOINT]);
  });

  it('turn the other way in a mirror', () => {
    const range: SketchJoint = { ...JOINT, range: [-30, 90] };
    const before = sketchOf(CRANE, { version: 2, joints: [range] });
    const { sketch } = copyLines(before, BOTH, [mirrorAt('x', -3)]);
    expect(sketch.joints?.[1]).toEqual({ at: [-6, 0, 6], axis: [0, 1, 0], range: [-90, 30] });
  });

  it('name the bodies of a joint by the copies', () => {
    const joint: SketchJoint = { at: [0, 0, 0], axis: [0, 1, 0], between: [[0], [2]] };
    const { sketch } = copyLines(sketchOf(CRANE, { joints: [joint] }), new Set([0, 2]), [
      shift([0, 4, 0]),
    ]);
    expect(sketch.joints?.[1]?.between).toEqual([[3], [4]]);
  });

  it('name the lines that turn where more than two meet', () => {
    const { sketch } = copyLines(sketchOf(CRANE, { joints: [JOINT] }), BOTH, [mirrorAt('z', 6)]);
    // The joint's image is the joint; the post's image hangs on its node.
    expect(sketch.joints).toEqual([JOINT]);
    const more = copyLines(
      sketchOf([...CRANE, { from: [0, 4, 6], to: [0, 9, 6] }], { joints: [JOINT] }),
      BOTH,
      [shift([0, 4, 0])],
    );
    expect(more.sketch.joints?.[1]?.between).toEqual([[4], [5]]);
  });

  it('have the colours of their lines', () => {
    const before = sketchOf(CRANE, { version: 2, colours: { lines: { 1: 4 } } });
    const { sketch } = copyLines(before, BOTH, [shift([0, 4, 0]), shift([0, 8, 0])]);
    expect(sketch.colours?.lines).toEqual({ 1: 4, 4: 4, 6: 4 });
  });

  it('lie on no line twice', () => {
    const { sketch, added } = copyLines(sketchOf(CRANE), new Set([0]), [mirrorAt('x', 0)]);
    expect(added).toEqual([]);
    expect(sketch.lines).toHaveLength(3);
  });
});

describe('offsets by numbers', () => {
  it('move, copy in a row and mirror', () => {
    const line = new Set([2]);
    const before = sketchOf(CRANE);
    const at = (offset: Parameters<typeof offsetLines>[2]) =>
      offsetLines(before, line, offset).sketch.lines.slice(2);
    expect(at({ kind: 'move', by: [1, -2, 3] })).toEqual([{ from: [1, -2, 3], to: [4, -2, 3] }]);
    expect(at({ kind: 'copies', by: [0, 2, 0], count: 2 }).map(({ from }) => from[1])).toEqual([
      0, 2, 4,
    ]);
    expect(at({ kind: 'mirror', axis: 'x', at: 3.5 })[1]).toEqual({
      from: [7, 0, 0],
      to: [4, 0, 0],
    });
  });

  it('are whole modules that lead somewhere', () => {
    expect(isOffset({ kind: 'move', by: [0, 0, 0] })).toBe(false);
    expect(isOffset({ kind: 'move', by: [0.5, 0, 0] })).toBe(false);
    expect(isOffset({ kind: 'copies', by: [0, 2, 0], count: 0 })).toBe(false);
    expect(isOffset({ kind: 'mirror', axis: 'x', at: 0.5 })).toBe(true);
    expect(isOffset({ kind: 'mirror', axis: 'x', at: Number.NaN })).toBe(false);
  });

  it('show where the lines would lie', () => {
    expect(offsetImages(sketchOf(CRANE), new Set([2]), { kind: 'move', by: [0, 1, 0] })).toEqual([
      [
        [0, 1, 0],
        [3, 1, 0],
      ],
    ]);
  });
});
