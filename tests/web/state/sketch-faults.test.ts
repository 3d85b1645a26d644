import { expect, test } from 'vitest';
import { emptySketch, type SketchLine } from '../../../web/src/model/sketch.ts';
import { mirrorPlace } from '../../../web/src/state/mirror-place.ts';
import { findFaults, mendFault } from '../../../web/src/state/sketch-faults.ts';

const sketchOf = (lines: readonly SketchLine[]) => ({ ...emptySketch(), lines });

const CROSSING = sketchOf([
  { from: [0, 0, 0], to: [8, 0, 0] },
  { from: [3.5, -4, 0], to: [3.5, 4, 0] },
]);

test('lines that cross between nodes are a fault, and its mend brings them to nodes', () => {
  const [fault] = findFaults(CROSSING);
  expect(fault).toMatchObject({ kind: 'crossing', lines: [0, 1] });
  expect(fault && findFaults(mendFault(CROSSING, fault))).toEqual([]);
});

test('lines that meet at nodes are no fault', () => {
  const cross = sketchOf([
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [3, -4, 0], to: [3, 4, 0] },
  ]);
  expect(findFaults(cross)).toEqual([]);
});

test('the same line twice, drawn either way, is a fault that removing one mends', () => {
  const doubled = sketchOf([
    { from: [0, 0, 0], to: [5, 0, 0] },
    { from: [5, 0, 0], to: [0, 0, 0] },
  ]);
  const [fault] = findFaults(doubled);
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
