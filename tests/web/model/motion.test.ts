import { expect, test } from 'vitest';
import { rotate } from '../../../web/src/geometry/vec.ts';
import { groupColours, type MotionPath, posesAt } from '../../../web/src/model/motion.ts';

const HALF = Math.SQRT1_2;

/** A part that turns by 90 degrees about z while it goes from the origin to (4, 0, 0). */
const PATH: MotionPath = {
  turns: true,
  message: '',
  parts: [7],
  angles: [0, 90],
  poses: [[[0, 0, 0, 0, 0, 0, 1]], [[4, 0, 0, 0, 0, HALF, HALF]]],
};

test('a key pose is taken as it is', () => {
  const turned = posesAt(PATH, 90).get(7);
  expect(turned?.position).toEqual([4, 0, 0]);
  const [x, y] = rotate(turned?.rotation ?? [1, 0, 0, 0, 1, 0, 0, 0, 1], [1, 0, 0]);
  expect(x).toBeCloseTo(0);
  expect(y).toBeCloseTo(1);
});

test('half way between two keys a part is turned by half', () => {
  const turned = posesAt(PATH, 45).get(7);
  expect(turned?.position[0]).toBeCloseTo(2);
  const [x, y] = rotate(turned?.rotation ?? [1, 0, 0, 0, 1, 0, 0, 0, 1], [1, 0, 0]);
  expect(x).toBeCloseTo(HALF);
  expect(y).toBeCloseTo(HALF);
});

test('beyond the ends a part stays at the end', () => {
  expect(posesAt(PATH, 200).get(7)?.position).toEqual([4, 0, 0]);
  expect(posesAt(PATH, -50).get(7)?.position).toEqual([0, 0, 0]);
});

test('quaternions of opposite sign are the same turn', () => {
  const flipped: MotionPath = {
    ...PATH,
    poses: [PATH.poses[0] ?? [], [[4, 0, 0, 0, 0, -HALF, -HALF]]],
  };
  const turned = posesAt(flipped, 45).get(7);
  const [x] = rotate(turned?.rotation ?? [1, 0, 0, 0, 1, 0, 0, 0, 1], [1, 0, 0]);
  expect(x).toBeCloseTo(HALF);
});

test('parts of one group have one colour, and two large groups differ', () => {
  const [a, b, c, d] = groupColours([0, 1, 0, 1]);
  expect(a).toBe(c);
  expect(b).toBe(d);
  expect(a).not.toBe(b);
});

test('parts alone in their group are all of one colour', () => {
  const [, , c, d] = groupColours([0, 0, 1, 2]);
  expect(c).toBe(d);
});
