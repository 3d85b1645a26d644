import { describe, expect, it } from 'vitest';
import { Catalogue, type Part } from '../../../web/src/model/catalogue.ts';
import type { Model } from '../../../web/src/model/model.ts';
import type { MotionPath, PathPose } from '../../../web/src/model/motion.ts';
import {
  anglesOf,
  type Course,
  jointPairs,
  momentsOf,
  nearestHole,
  periodOf,
  traceOf,
} from '../../../web/src/model/motion-curves.ts';
import { localOf, nearestAngle, pointOf } from '../../../web/src/model/motion-follow.ts';
import { mixedPose, mixedPoses } from '../../../web/src/model/motion-mix.ts';
import { motionTable } from '../../../web/src/ui/motion/motion-table.ts';

/** A turn about z at the origin. */
function turned(degrees: number): PathPose {
  const half = (degrees * Math.PI) / 360;
  return [0, 0, 0, 0, 0, Math.sin(half), Math.cos(half)];
}

function turning(from: number, to: number, parts: readonly number[]): MotionPath {
  const angles = Array.from({ length: to - from + 1 }, (_, i) => from + i);
  const poses = angles.map((degrees) => parts.map(() => turned(degrees)));
  return { turns: true, message: '', parts, angles, poses };
}

const BEAM = {
  id: '1',
  features: [
    { kind: 'pinHole', center: [0, 0, 0], axis: [0, 0, 1], length: 1, slots: [[0, 0, 0]] },
    { kind: 'pinHole', center: [4, 0, 0], axis: [0, 0, 1], length: 1, slots: [[4, 0, 0]] },
  ],
} as unknown as Part;
const CATALOGUE = new Catalogue([BEAM]);

const place = {
  part: '1',
  color: 7,
  layer: 0,
  component: 0,
  rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1],
};
const MODEL = {
  name: '',
  parts: [
    { ...place, position: [0, 0, 0] },
    { ...place, position: [0, 0, 1] },
    { ...place, position: [10, 0, 0] },
  ],
} as unknown as Model;

const course = (path: MotionPath, mode: Course['mode'] = 'loop'): Course => ({
  driven: [{ path, degrees: 0 }],
  mode,
  degreesPerSecond: 45,
});

describe('a course', () => {
  it('is a full turn, or there and back', () => {
    expect(periodOf(course(turning(-180, 180, [1])))).toBe(8);
    expect(periodOf(course(turning(-180, 180, [1]), 'swing'))).toBe(16);
    expect(periodOf(course(turning(-30, 60, [1])))).toBe(4);
    const degrees = momentsOf(course(turning(-30, 60, [1]))).map(
      ({ driven }) => driven[0]?.degrees,
    );
    expect([degrees[0], Math.max(...degrees.map(Number)), degrees.at(-1)]).toEqual([-30, 60, -30]);
  });

  it('takes a point round its axis', () => {
    const moments = momentsOf(course(turning(-180, 180, [1])));
    const way = traceOf(MODEL, { part: 1, local: [4, 0, 0] }, moments);
    expect(way).toHaveLength(moments.length);
    for (const [x, y] of way) {
      expect(Math.hypot(x, y)).toBeCloseTo(4, 3);
    }
    expect(way[0]?.[0]).toBeCloseTo(-4);
  });

  it('leaves a point where it is that nothing moves', () => {
    const moments = momentsOf(course(turning(0, 90, [1])));
    const way = traceOf(MODEL, { part: 0, local: [4, 0, 0] }, moments);
    expect(way.every((at) => at.join() === '4,0,0')).toBe(true);
  });
});

describe('angles of joints', () => {
  const asked = { joints: [{ at: [0, 0, 0], axis: [0, 0, 1] }] as const, groups: [0, 1, 0] };

  it('are between the bodies with a hole on the axis', () => {
    expect(jointPairs(MODEL, CATALOGUE, asked)).toEqual([
      { joint: 0, axis: [0, 0, 1], parts: [0, 1] },
    ]);
    const aside = { ...asked, joints: [{ at: [1, 0, 0], axis: [0, 0, 1] }] as const };
    expect(jointPairs(MODEL, CATALOGUE, aside)).toEqual([]);
  });

  it('follow the motion without a leap at half a turn', () => {
    const [pair] = jointPairs(MODEL, CATALOGUE, asked);
    const moments = momentsOf(course(turning(-180, 180, [1])));
    const angles = pair ? anglesOf(MODEL, pair, moments) : [];
    expect(Math.abs(angles[0] ?? 0)).toBeCloseTo(180);
    expect((angles.at(-1) ?? 0) - (angles[0] ?? 0)).toBeCloseTo(360);
    const steps = angles.slice(1).map((angle, i) => angle - (angles[i] ?? 0));
    expect(Math.max(...steps)).toBeLessThan(4);
  });
});

describe('what is dragged', () => {
  it('comes nearest to the pointer', () => {
    const path = turning(-180, 180, [1]);
    const at = [0, 4];
    const off = (degrees: number) => {
      const pose = mixedPose([{ path, degrees }], 1);
      const [x, y] = pose ? pointOf(pose, [4, 0, 0]) : [0, 0];
      return Math.hypot(x - (at[0] ?? 0), y - (at[1] ?? 0));
    };
    expect(nearestAngle({ from: -180, to: 180 }, 40, off)).toBeCloseTo(90, 1);
    expect(nearestAngle({ from: -180, to: 60 }, 40, off)).toBeCloseTo(60, 1);
  });

  it('goes over the ends of a full turn', () => {
    const off = (degrees: number) => Math.abs(degrees + 170);
    expect(nearestAngle({ from: -180, to: 180 }, 170, off)).toBeCloseTo(-170, 1);
  });

  it('is held where it was pressed', () => {
    const pose = { position: [1, 2, 3], rotation: [0, -1, 0, 1, 0, 0, 0, 0, 1] } as const;
    expect(pointOf(pose, localOf(pose, [5, 5, 5]))).toEqual([5, 5, 5]);
  });

  it('stands where several motions together have it', () => {
    const driven = [
      { path: turning(-90, 90, [1, 2]), degrees: 30 },
      { path: turning(-90, 90, [1]), degrees: 20 },
    ];
    expect(mixedPose(driven, 1)).toEqual(mixedPoses(driven).get(1));
    expect(mixedPose(driven, 0)).toBeNull();
  });
});

it('the hole that is meant is the nearest one', () => {
  expect(nearestHole(CATALOGUE, { part: '1' }, [3.6, 0.4, 0.5])).toEqual([4, 0, 0]);
  expect(nearestHole(CATALOGUE, { part: '2' }, [0, 0, 0])).toBeNull();
});

it('a table has the seconds, the angles and the ways', () => {
  const table = motionTable(
    [0, 1],
    [{ name: 'Joint 1', angles: [0, 45] }],
    [
      [
        [0, 0, 0],
        [1, 2, 3.00004],
      ],
    ],
  );
  expect(table).toBe(
    'seconds,Joint 1 (degrees),Point 1 x,Point 1 y,Point 1 z\n0,0,0,0,0\n1,45,1,2,3\n',
  );
});
