import { expect, it } from 'vitest';
import type { Vec3 } from '../../../web/src/geometry/vec.ts';
import { bodiesOfLines } from '../../../web/src/model/line-bodies.ts';
import type { SketchDocument, SketchJoint } from '../../../web/src/model/sketch.ts';

const chain = (joints: readonly SketchJoint[], ...points: Vec3[]): SketchDocument => ({
  format: 'technic-sketch',
  version: 1,
  lines: points.slice(1).map((to, i) => ({ from: points[i] ?? to, to })),
  joints,
});

it('lines that share a node move as one', () => {
  expect(bodiesOfLines(chain([], [0, 0, 0], [4, 0, 0], [4, 3, 0]))).toEqual([0, 0]);
});

it('a joint sets lines apart at its node', () => {
  const joint: SketchJoint = { at: [4, 0, 0], axis: [0, 0, 1] };
  expect(bodiesOfLines(chain([joint], [0, 0, 0], [4, 0, 0], [4, 3, 0], [8, 3, 0]))).toEqual([
    0, 1, 1,
  ]);
});

it('three bodies on one pin are three', () => {
  const at: Vec3 = [0, 0, 0];
  const sketch: SketchDocument = {
    format: 'technic-sketch',
    version: 1,
    lines: [
      { from: at, to: [4, 0, 0] },
      { from: at, to: [0, 4, 0] },
      { from: at, to: [0, 0, 4] },
    ],
    joints: [{ at, axis: [0, 0, 1], between: [[0], [1], [2]] }],
  };
  expect(bodiesOfLines(sketch)).toEqual([0, 1, 2]);
});

it('what is joined elsewhere moves as one all the same', () => {
  const joint: SketchJoint = { at: [0, 0, 0], axis: [0, 0, 1], between: [[0], [3]] };
  const square = chain([joint], [0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [0, 0, 0]);
  expect(bodiesOfLines(square)).toEqual([0, 0, 0, 0]);
});
