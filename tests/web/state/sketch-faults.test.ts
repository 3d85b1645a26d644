import { expect, test } from 'vitest';
import { emptySketch, type SketchLine } from '../../../web/src/model/sketch.ts';
import { mirrorPlace } from '../../../web/src/state/mirror-place.ts';
import { findTwins, mendFault, type SketchFault } from '../../../web/src/state/sketch-faults.ts';

const sketchOf = (lines: readonly SketchLine[]) => ({ ...emptySketch(), lines });

test('a mend moves lines and keeps all else of them', () => {
  const sketch = sketchOf([
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [3, 0, 0.09], to: [3, 0, 5.09], exact: true },
  ]);
  const fault: SketchFault = {
    kind: 'near',
    message: '',
    at: [3, 0, 0],
    lines: [0, 1],
    mend: [{ line: 1, from: [3, 0, 0], to: [3, 0, 5] }],
  };
  expect(mendFault(sketch, fault).lines).toEqual([
    sketch.lines[0],
    { from: [3, 0, 0], to: [3, 0, 5], exact: true },
  ]);
});

test('a mend without a number is a line more', () => {
  const sketch = sketchOf([{ from: [0, 0, 0], to: [8, 0, 0] }]);
  const mend = [{ from: [8, 0, 0], to: [20, 0, 0] }] as const;
  const fault: SketchFault = { kind: 'pieces', message: '', at: [8, 0, 0], lines: [0], mend };
  expect(mendFault(sketch, fault).lines).toEqual([...sketch.lines, ...mend]);
});

test('a mend for a line that is gone changes nothing', () => {
  const sketch = sketchOf([{ from: [0, 0, 0], to: [8, 0, 0] }]);
  const mend = [{ line: 4, from: [0, 0, 0], to: [1, 0, 0] }] as const;
  const fault: SketchFault = { kind: 'near', message: '', at: [0, 0, 0], lines: [4, 0], mend };
  expect(mendFault(sketch, fault).lines).toEqual(sketch.lines);
});

test('the same line twice, drawn either way, is a fault that removing one mends', () => {
  const doubled = sketchOf([
    { from: [0, 0, 0], to: [5, 0, 0] },
    { from: [5, 0, 0], to: [0, 0, 0] },
  ]);
  const [fault] = findTwins(doubled);
  expect(fault?.kind).toBe('twin');
  expect(fault && mendFault(doubled, fault).lines).toHaveLength(1);
});

/** A hull along y at x = 2, and a wing that hangs on it. */
const HALF_PLANE = sketchOf([
  { from: [2, 0, 0], to: [2, 12, 0] },
  { from: [2, 4, 0], to: [9, 4, 0] },
  { from: [2, 8, 0], to: [9, 8, 0] },
]);

test('a wing is mirrored where it hangs on the hull', () => {
  expect(mirrorPlace(HALF_PLANE, new Set([1, 2]), 'x')).toBe(2);
});

test('a whole sketch is mirrored at its far side', () => {
  expect(mirrorPlace(HALF_PLANE, new Set([0, 1, 2]), 'x')).toBe(9);
});

test('a mirror plane of the sketch is used where nothing else says where', () => {
  const planned = {
    ...HALF_PLANE,
    symmetries: [{ kind: 'reflection', normal: [1, 0, 0], offset: -1 } as const],
  };
  expect(mirrorPlace(planned, new Set([0, 1, 2]), 'x')).toBe(-1);
});
