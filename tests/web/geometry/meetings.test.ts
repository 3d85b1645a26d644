import { describe, expect, it } from 'vitest';
import { meetings } from '../../../web/src/geometry/meetings.ts';
import { distance } from '../../../web/src/geometry/vec.ts';

describe('meetings', () => {
  it('finds the corner that two lines share', () => {
    const found = meetings([
      { from: [0, 0, 0], to: [5, 0, 0] },
      { from: [5, 0, 0], to: [5, 4, 0] },
    ]);
    expect(found).toEqual([{ at: [5, 0, 0], lines: [0, 1], atNode: true }]);
  });

  it('finds a T contact and a crossing at nodes', () => {
    const found = meetings([
      { from: [0, 0, 0], to: [6, 0, 0] },
      { from: [2, 0, 0], to: [2, 5, 0] },
      { from: [4, -3, 0], to: [4, 3, 0] },
    ]);
    expect(found.map((meeting) => meeting.at)).toEqual([
      [2, 0, 0],
      [4, 0, 0],
    ]);
    expect(found.every((meeting) => meeting.atNode)).toBe(true);
  });

  it('tells a crossing between nodes, where no pin can join', () => {
    const [found, ...more] = meetings([
      { from: [0, 0, 0], to: [3, 4, 0] },
      { from: [0, 1, 0], to: [4, 1, 0] },
    ]);
    expect(more).toEqual([]);
    expect(found?.atNode).toBe(false);
    expect(found?.at[0]).toBeCloseTo(0.75, 12);
  });

  it('finds a crossing far from all ends', () => {
    const found = meetings([
      { from: [-50, 0.5, 7], to: [50, 0.5, 7] },
      { from: [7.5, -40, 7], to: [7.5, 40, 7] },
    ]);
    expect(found).toHaveLength(1);
    expect(distance(found[0]?.at ?? [0, 0, 0], [7.5, 0.5, 7])).toBeLessThan(1e-9);
  });

  it('sees nothing where lines pass each other', () => {
    const found = meetings([
      { from: [0, 0, 0], to: [3, 4, 0] },
      { from: [0, 1, 1], to: [4, 1, 1] },
    ]);
    expect(found).toEqual([]);
  });

  it('gives only the ends of what collinear lines share', () => {
    const found = meetings([
      { from: [0, 0, 0], to: [6, 0, 0] },
      { from: [4, 0, 0], to: [9, 0, 0] },
    ]);
    expect(found.map((meeting) => meeting.at[0])).toEqual([4, 6]);
  });

  it('joins points that differ by rounding alone', () => {
    const h = 2 * Math.sqrt(3);
    const found = meetings([
      { from: [0, 0, 0], to: [2, 0, h] },
      { from: [4, 0, 0], to: [2, 0, h + 1e-9] },
    ]);
    expect(found).toHaveLength(1);
  });

  it('takes a grid of 400 lines', () => {
    const steps = Array.from({ length: 200 }, (_, i) => i);
    const lines = steps.flatMap((i) => [
      { from: [i, 0, 0], to: [i, 50, 0] } as const,
      { from: [0, i, 1], to: [50, i, 1] } as const,
    ]);
    expect(meetings(lines)).toEqual([]);
  });
});
