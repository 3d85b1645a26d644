import { describe, expect, it } from 'vitest';
import { type Outline, outlineBars, signedArea } from '../../../web/src/view/bricks/outline.ts';

const RADIUS = 0.45;

function area(outline: Outline | undefined): number {
  return outline ? signedArea(outline) / 2 : 0;
}

describe('outlineBars', () => {
  it('makes a disc of a lone point', () => {
    const outlines = outlineBars({ points: [[2, 3]], bars: [] }, RADIUS, 64);
    expect(outlines).toHaveLength(1);
    expect(area(outlines[0])).toBeCloseTo(Math.PI * RADIUS ** 2, 2);
  });

  it('makes a stadium of one bar', () => {
    const graph = { points: [[0, 0] as const, [4, 0] as const], bars: [[0, 1] as const] };
    const outlines = outlineBars(graph, RADIUS, 64);
    expect(outlines).toHaveLength(1);
    expect(area(outlines[0])).toBeCloseTo(4 * 2 * RADIUS + Math.PI * RADIUS ** 2, 2);
  });

  it('gives an L one sharp inner corner', () => {
    const points = [[3, 0] as const, [0, 0] as const, [0, 2] as const];
    const bars = [[0, 1] as const, [1, 2] as const];
    const outline = outlineBars({ points, bars }, RADIUS, 32)[0] ?? [];
    const sharp = outline.filter(
      ({ before, after }) => before[0] * after[0] + before[1] * after[1] < 0.5,
    );
    expect(sharp.map(({ point }) => point.map((value) => Number(value.toFixed(6))))).toEqual([
      [RADIUS, RADIUS],
    ]);
  });

  it('gives a ring of bars an inner outline that runs the other way', () => {
    const points = [[0, 0] as const, [4, 0] as const, [4, 3] as const, [0, 3] as const];
    const bars = [[0, 1] as const, [1, 2] as const, [2, 3] as const, [3, 0] as const];
    const areas = outlineBars({ points, bars }, RADIUS, 32).map(area);
    expect(areas.filter((value) => value > 0)).toHaveLength(1);
    expect(areas.filter((value) => value < 0)).toHaveLength(1);
    expect(Math.min(...areas)).toBeCloseTo(-(4 - 2 * RADIUS) * (3 - 2 * RADIUS), 6);
  });

  it('keeps every vertex at the radius from a bar, inner corners apart', () => {
    const points = [[-1, 0] as const, [0, 0] as const, [1, 0] as const, [0, -2] as const];
    const bars = [[0, 1] as const, [1, 2] as const, [1, 3] as const];
    for (const { point } of outlineBars({ points, bars }, RADIUS, 16)[0] ?? []) {
      const toRow = Math.hypot(Math.max(0, Math.abs(point[0]) - 1), point[1]);
      const toStem = Math.hypot(point[0], Math.max(0, point[1], -2 - point[1]));
      expect(Math.min(toRow, toStem)).toBeCloseTo(RADIUS, 6);
    }
  });
});
