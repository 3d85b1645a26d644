import { expect, test } from 'vitest';
import { IDENTITY, type Vec3 } from '../../../web/src/geometry/vec.ts';
import { unfitParts } from '../../../web/src/model/fitting-parts.ts';
import type { PlacedPart } from '../../../web/src/model/model.ts';
import { emptySketch, type SketchLine } from '../../../web/src/model/sketch.ts';

const partAt = (position: Vec3): PlacedPart => ({
  part: '32524',
  color: 71,
  position,
  rotation: IDENTITY,
  component: 0,
  layer: 0,
  piece: 0,
});

const A: SketchLine = { from: [0, 0, 0], to: [6, 0, 0] };
const B: SketchLine = { from: [0, 0, 0], to: [0, 6, 0] };
const C: SketchLine = { from: [6, 0, 0], to: [6, 6, 0] };
const sketchOf = (...lines: SketchLine[]) => ({ ...emptySketch(), lines });
const PARTS = [partAt([3, 0, 0]), partAt([0, 4, 1])];

test('a line that has come leaves every part as it is', () => {
  expect(unfitParts(PARTS, sketchOf(A, B), sketchOf(A, B, C))).toEqual(new Set());
});

test('a line that is gone takes its parts and no others', () => {
  expect(unfitParts(PARTS, sketchOf(A, B), sketchOf(A))).toEqual(new Set([1]));
});
