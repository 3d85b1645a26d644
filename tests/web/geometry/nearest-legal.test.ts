import { describe, expect, it } from 'vitest';
import { isLegalLine } from '../../../web/src/geometry/legal-line.ts';
import { nearestLegal, type Segment } from '../../../web/src/geometry/nearest-legal.ts';
import { distance, type Vec3 } from '../../../web/src/geometry/vec.ts';

/** Lines from point to point. */
const chain = (...points: Vec3[]): Segment[] =>
  points.slice(1).map((to, i) => ({ from: points[i] ?? to, to }));

function nearest(lines: readonly Segment[]) {
  const found = nearestLegal(lines);
  expect(found).not.toBeNull();
  for (const { from, to } of found?.lines ?? []) {
    expect(isLegalLine(from, to)).toBe(true);
  }
  return found ?? { lines: [], moved: [] };
}

describe('the nearest drawing that can be built', () => {
  it('is the drawing itself where that can be', () => {
    const lines = chain([0, 0, 0], [8, 0, 0], [8, 6, 0], [0, 0, 0]);
    expect(nearest(lines)).toEqual({ lines, moved: [0, 0, 0] });
  });

  it('has the whole lengths next to those of a modelling program', () => {
    const { lines, moved } = nearest(
      chain([0, 0, 0.01], [7.93, 0, 0], [7.95, 6.05, 0.02], [0, 6, 0], [0, 0.02, 0]),
    );
    expect(lines.map(({ from }) => from)).toEqual([
      [0, 0, 0],
      [8, 0, 0],
      [8, 6, 0],
      [0, 6, 0],
    ]);
    expect(Math.max(...moved)).toBeLessThan(0.1);
  });

  it('joins ends that nearly touch', () => {
    const { lines } = nearest([
      { from: [0, 0, 0], to: [6, 0, 0] },
      { from: [6.09, 0, 0], to: [6.09, 0, 4] },
    ]);
    expect(lines[1]?.from).toEqual(lines[0]?.to);
  });

  it('joins an end to the node inside a line that it nearly touches', () => {
    const { lines } = nearest([
      { from: [0, 0, 0], to: [8, 0, 0] },
      { from: [3.09, 0, 0.05], to: [3.09, 0, 5.05] },
    ]);
    expect(lines[1]?.from).toEqual([3, 0, 0]);
    expect(lines[1]?.to).toEqual([3, 0, 5]);
  });

  it('keeps a triangle of sixty degrees, whose corners are at no whole places', () => {
    const apex: Vec3 = [3.02, 0, 5.18];
    const { lines } = nearest(chain([0, 0, 0], [6.03, 0, 0], apex, [0, 0, 0]));
    expect(lines.map(({ from, to }) => Math.round(distance(from, to) * 1e6) / 1e6)).toEqual([
      6, 6, 6,
    ]);
  });

  it('keeps a slope of three, four and five', () => {
    const { lines } = nearest(chain([0, 0, 0], [3.04, 0, 3.97], [6.02, 0, 0.03]));
    expect(lines.map(({ to }) => to)).toEqual([
      [3, 0, 4],
      [6, 0, 0],
    ]);
  });

  it('is none where a line lies in no plane, or where all would have to move far', () => {
    expect(nearestLegal(chain([0, 0, 0], [2, 3, 6]))).toBeNull();
    expect(nearestLegal(chain([0, 0, 0], [0.1, 0, 0]))).toBeNull();
    // A right angle between sides of one: no third side is whole nearby.
    expect(nearestLegal(chain([0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0]))).toBeNull();
  });

  it.each([1, 2, 3, 4, 5])('is found again when a frame is shaken (%i)', (seed) => {
    let state = seed * 7919;
    const dust = () => {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      return (state / 2 ** 32 - 0.5) * 0.08;
    };
    const shaken = ([x, y, z]: Vec3): Vec3 => [x + dust(), y + dust(), z + dust()];
    const frame = chain([0, 0, 0], [9, 0, 0], [9, 0, 5], [0, 0, 5], [0, 0, 0], [0, 7, 0]);
    const { lines } = nearest(
      frame.map(({ from, to }) => ({ from: shaken(from), to: shaken(to) })),
    );
    expect(lines).toEqual(frame);
  });
});
