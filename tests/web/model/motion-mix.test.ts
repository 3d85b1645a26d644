import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../../web/src/geometry/vec.ts';
import type { MotionPath, PathPose } from '../../../web/src/model/motion.ts';
import { canMix, mixedPoses } from '../../../web/src/model/motion-mix.ts';
import { isFullTurn } from '../../../web/src/model/motion-span.ts';

/** Parts at points of the x axis that turn about z at a place of it. */
function turning(parts: readonly (readonly [number, number])[], centre: number): MotionPath {
  const angles = Array.from({ length: 73 }, (_, i) => -180 + 5 * i);
  const pose = (x: number, degrees: number): PathPose => {
    const a = (degrees * Math.PI) / 180;
    const r = x - centre;
    return [centre + r * Math.cos(a), r * Math.sin(a), 0, 0, 0, Math.sin(a / 2), Math.cos(a / 2)];
  };
  return {
    turns: true,
    message: '',
    parts: parts.map(([part]) => part),
    angles,
    poses: angles.map((degrees) => parts.map(([, x]) => pose(x, degrees))),
  };
}

/** An upper arm from 0 to 4 and a forearm from 4 to 7: parts 1 and 2. */
const SHOULDER = turning(
  [
    [1, 2],
    [2, 5],
  ],
  0,
);
const ELBOW = turning([[2, 5]], 4);
const ELSEWHERE = turning([[3, 9]], 8);

const near = (p: Vec3 | undefined, q: Vec3) => {
  for (const k of [0, 1, 2] as const) {
    expect(p?.[k]).toBeCloseTo(q[k], 5);
  }
};

describe('motions that can be had together', () => {
  it('move different parts, or one carries what the other moves', () => {
    expect(canMix([SHOULDER, ELBOW, ELSEWHERE])).toBe(true);
  });

  it('are not those of one closed chain', () => {
    const bent: MotionPath = {
      ...SHOULDER,
      parts: [1, 2, 4],
      poses: SHOULDER.poses.map(([a, b], i) => [
        a as PathPose,
        b as PathPose,
        ELBOW.poses[i]?.[0] as PathPose,
      ]),
    };
    const chain = { ...bent, parts: [4, 1, 2] };
    expect(canMix([bent, chain])).toBe(false);
    expect(
      canMix([
        bent,
        { ...ELBOW, parts: [2, 4], poses: ELBOW.poses.map(([p]) => [p, p] as PathPose[]) },
      ]),
    ).toBe(false);
  });

  it('add up: the shoulder carries the bent elbow', () => {
    const poses = mixedPoses([
      { path: SHOULDER, degrees: 90 },
      { path: ELBOW, degrees: 90 },
    ]);
    // The elbow at 4 goes to (0, 4); the forearm, a module beyond it, points back along x.
    near(poses.get(2)?.position, [-1, 4, 0]);
    near(poses.get(1)?.position, [0, 2, 0]);
  });

  it('add up the same in either order', () => {
    const a = { path: SHOULDER, degrees: 30 };
    const b = { path: ELBOW, degrees: -70 };
    expect(mixedPoses([a, b])).toEqual(mixedPoses([b, a]));
  });
});

it('a span of a full turn is known as one', () => {
  expect(isFullTurn({ from: -180, to: 180 })).toBe(true);
});
