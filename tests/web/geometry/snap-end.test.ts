import { describe, expect, it } from 'vitest';
import { legalEnds, type SnapContext, snapEnd } from '../../../web/src/geometry/snap-end.ts';
import { distance, type Vec3 } from '../../../web/src/geometry/vec.ts';

const LEVEL = { normal: 'z', through: [0, 0, 0] } as const;

function context(part: Partial<SnapContext>): SnapContext {
  const base = { start: null, plane: LEVEL, lines: [], lockAxis: null } as const;
  return { ...base, cursor: [0, 0, 0], tolerance: 0.4, ...part };
}

const LINE = { from: [0, 0, 0], to: [6, 0, 0] } as const;

describe('the first point', () => {
  it('lies on whole numbers of the plane where nothing is near', () => {
    const plane = { normal: 'z', through: [0, 0, 2.5] } as const;
    const snap = snapEnd(context({ plane, cursor: [1.4, -0.2, 2.5] }));
    expect(snap).toEqual({ point: [1, 0, 2.5], reason: 'plane', length: 0 });
  });

  it('is drawn to an end point and to a node inside a line', () => {
    expect(snapEnd(context({ lines: [LINE], cursor: [6.2, 0.1, 0] })).reason).toBe('endpoint');
    const snap = snapEnd(context({ lines: [LINE], cursor: [2.9, 0.2, 0] }));
    expect(snap).toEqual({ point: [3, 0, 0], reason: 'node', length: 0 });
  });

  it('finds nodes off the lattice', () => {
    const line = { from: [0, 0, 0], to: [3, 4, 0] } as const;
    const snap = snapEnd(context({ lines: [line], cursor: [0.7, 0.7, 0] }));
    expect(snap.reason).toBe('node');
    expect(distance(snap.point, [0.6, 0.8, 0])).toBeLessThan(1e-12);
  });

  it('is not drawn to a node farther than the tolerance', () => {
    expect(snapEnd(context({ lines: [LINE], cursor: [3, 0.5, 0] })).reason).toBe('plane');
  });
});

describe('the end of a line', () => {
  const start: Vec3 = [0, 0, 0];

  it('runs along an axis by whole modules', () => {
    const snap = snapEnd(context({ start, cursor: [4.6, 0.3, 0] }));
    expect(snap).toEqual({ point: [5, 0, 0], reason: 'axis', length: 5 });
  });

  it('finds a 3-4-5 slope and its multiples', () => {
    const snap = snapEnd(context({ start, cursor: [5.9, 8.2, 0] }));
    expect(snap).toEqual({ point: [6, 8, 0], reason: 'pythagorean', length: 10 });
  });

  it.each([
    [[5, 12, 0], 13],
    [[-8, 15, 0], 17],
    [[24, -7, 0], 25],
  ] as const)('finds the slope to %j', (cursor, length) => {
    expect(snapEnd(context({ start, cursor }))).toEqual({
      point: cursor,
      reason: 'pythagorean',
      length,
    });
  });

  it('finds 60 degrees', () => {
    const snap = snapEnd(context({ start, cursor: [2, 3.5, 0] }));
    expect(snap.reason).toBe('sixty');
    expect(snap.length).toBe(4);
    expect(distance(snap.point, [2, 2 * Math.sqrt(3), 0])).toBeLessThan(1e-12);
  });

  it('goes parallel to a line that is there', () => {
    const line = { from: [10, 0, 0], to: [13, 4, 0] } as const;
    const snap = snapEnd(context({ start, lines: [line], cursor: [1.25, 1.55, 0] }));
    expect(snap.reason).toBe('parallel');
    expect(snap.length).toBe(2);
    expect(distance(snap.point, [1.2, 1.6, 0])).toBeLessThan(1e-12);
  });

  it('ends at an end point before anything else, when the length is whole', () => {
    const lines = [{ from: [5, 0, 0], to: [5, 0, 7] }] as const;
    const snap = snapEnd(context({ start, lines, cursor: [5.2, 0.2, 0] }));
    expect(snap).toEqual({ point: [5, 0, 0], reason: 'endpoint', length: 5 });
  });

  it('does not end at a point to which the length would not be whole', () => {
    const lines = [{ from: [3, 2, 0], to: [9, 2, 0] }] as const;
    const snap = snapEnd(context({ start, lines, cursor: [3, 2, 0] }));
    expect(distance(snap.point, [3, 2, 0])).toBeGreaterThan(0.1);
  });

  it('does not end at a point that makes a space diagonal', () => {
    const lines = [{ from: [2, 3, 6], to: [9, 3, 6] }] as const;
    const snap = snapEnd(context({ start, lines, cursor: [2, 3, 6] }));
    expect(snap.point[2]).toBe(0);
  });

  it('stays on a locked axis, whatever the plane', () => {
    const snap = snapEnd(context({ start, lockAxis: 'z', cursor: [4, 1, -3.4] }));
    expect(snap).toEqual({ point: [0, 0, -3], reason: 'axis', length: 3 });
  });

  it('meets a node on a locked axis', () => {
    const lines = [{ from: [0, -2, 4], to: [0, 2, 4] }] as const;
    const snap = snapEnd(context({ start, lines, lockAxis: 'z', cursor: [0, 0.1, 4.1] }));
    expect(snap).toEqual({ point: [0, 0, 4], reason: 'node', length: 4 });
  });

  it('is one module long when the pointer is still at the start', () => {
    expect(snapEnd(context({ start, cursor: [0, 0.1, 0] }))).toEqual({
      point: [0, 1, 0],
      reason: 'axis',
      length: 1,
    });
  });

  it('lies in the plane through the start, not in the plane of the pointer', () => {
    const snap = snapEnd(context({ start: [0, 0, 2], cursor: [3, 0, 0] }));
    expect(snap.point).toEqual([3, 0, 2]);
  });
});

describe('a pointer that moves a little', () => {
  it('moves the end no further than to a neighbour', () => {
    const start: Vec3 = [0, 0, 0];
    // Round the apex of 3, 4 and 5, once the end leapt to the axis, four modules away.
    for (let i = 0; i < 200; i++) {
      const angle = (i / 200) * 2 * Math.PI;
      const cursor: Vec3 = [3 + Math.cos(angle), 4 + Math.sin(angle), 0];
      const { point } = snapEnd(context({ start, cursor }));
      expect(distance(point, cursor)).toBeLessThan(2);
    }
  });
});

describe('the ends that are shown', () => {
  const start: Vec3 = [0, 0, 0];

  it('are whole lengths from the start, near the pointer, the nearest first', () => {
    const cursor: Vec3 = [3.2, 3.9, 0];
    const ends = legalEnds({ ...context({ cursor }), start }, 2.6);
    expect(ends[0]).toEqual([3, 4, 0]);
    expect(ends.length).toBeGreaterThan(3);
    for (const end of ends) {
      const length = distance(start, end);
      expect(Math.abs(length - Math.round(length))).toBeLessThan(1e-6);
      expect(distance(end, cursor)).toBeLessThanOrEqual(2.6);
    }
  });

  it('have among them the one that is chosen', () => {
    for (const cursor of [
      [4.6, 0.3, 0],
      [5.9, 8.2, 0],
      [2, 3.5, 0],
      [7.3, 2.1, 0],
    ] as const) {
      const { point } = snapEnd(context({ start, cursor }));
      const ends = legalEnds({ ...context({ cursor }), start }, 2.6);
      expect(ends.some((end) => distance(end, point) < 1e-9)).toBe(true);
    }
  });

  it('lie on a locked axis alone', () => {
    const ends = legalEnds({ ...context({ lockAxis: 'z', cursor: [0, 0, 3.4] }), start }, 1.5);
    expect(ends).toEqual([
      [0, 0, 3],
      [0, 0, 4],
      [0, 0, 2],
    ]);
  });
});

/** Fixed pseudo-random numbers in [0, 1), so that a failure repeats. */
function numbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
}

describe('any pointer', () => {
  it('gives whole lengths in principal planes, always', () => {
    const next = numbers(7);
    const spread = () => next() * 40 - 20;
    const lines = [
      { from: [0, 0, 0], to: [6, 8, 0] },
      { from: [2, 0, 0], to: [2, 2.5, 2.5 * Math.sqrt(3)] },
      { from: [-3, 1, 0], to: [-3, 1, 9] },
    ] as const;
    for (let i = 0; i < 1000; i++) {
      const normal = (['x', 'y', 'z'] as const)[i % 3] ?? 'z';
      const start: Vec3 = [Math.round(spread()), Math.round(spread()), i % 2 ? 0 : 2.5];
      const snap = snapEnd({
        start,
        plane: { normal, through: start },
        lines,
        lockAxis: i % 7 === 0 ? 'x' : null,
        cursor: [spread(), spread(), spread()],
        tolerance: 0.6,
      });
      expect(Number.isInteger(snap.length) && snap.length >= 1).toBe(true);
      expect(Math.abs(distance(start, snap.point) - snap.length)).toBeLessThan(1e-3);
      expect(snap.point.some((value, k) => Math.abs(value - (start[k] ?? 0)) < 1e-3)).toBe(true);
    }
  });
});
