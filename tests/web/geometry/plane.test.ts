import { describe, expect, it } from 'vitest';
import { meetPlane, nearestAlongAxis, projectToPlane } from '../../../web/src/geometry/plane.ts';

const UPRIGHT = { normal: 'y', through: [0, 2, 0] } as const;

describe('a ray', () => {
  it('meets a plane exactly on it', () => {
    const point = meetPlane({ origin: [1, -1, 5], direction: [0.6, 0.8, 0] }, UPRIGHT);
    expect(point?.[1]).toBe(2);
    expect(point?.[0]).toBeCloseTo(3.25, 12);
  });

  it('does not meet a plane behind it or along it', () => {
    expect(meetPlane({ origin: [0, 5, 0], direction: [0, 1, 0] }, UPRIGHT)).toBeNull();
    expect(meetPlane({ origin: [0, 5, 0], direction: [1, 0, 0] }, UPRIGHT)).toBeNull();
  });

  it('passes an axis nearest at a point of it', () => {
    const ray = { origin: [4, -9, 1], direction: [0, 1, 0] } as const;
    expect(nearestAlongAxis(ray, [1, 0, 0], 'x')).toBeCloseTo(3, 12);
  });

  it('has no nearest point on an axis that it runs along', () => {
    const ray = { origin: [4, -9, 1], direction: [0, 1, 0] } as const;
    expect(nearestAlongAxis(ray, [1, 0, 0], 'y')).toBeNull();
  });
});

describe('a point', () => {
  it('falls onto a plane along its normal', () => {
    expect(projectToPlane([3, 7, 4], UPRIGHT)).toEqual([3, 2, 4]);
  });
});
