import { describe, expect, test } from 'vitest';
import { type DrawnPath, pathJson } from '../../../web/src/model/linkage-answer.ts';
import { comesBack, pathOfShape } from '../../../web/src/model/path-shapes.ts';

const PATH: DrawnPath = {
  points: [
    [1, 2],
    [3, 4],
  ],
  closed: false,
  kind: 'line',
  normal: 'y',
};

describe('path files', () => {
  test('a path lies in the plane that it was drawn on', () => {
    const points = (normal: DrawnPath['normal']): unknown =>
      (JSON.parse(pathJson({ ...PATH, normal })) as { points: unknown }).points;
    expect(points('y')).toEqual([
      [1, 0, 2],
      [3, 0, 4],
    ]);
    expect(points('x')).toEqual([
      [0, 1, 2],
      [0, 3, 4],
    ]);
    expect(points('z')).toEqual([
      [1, 2, 0],
      [3, 4, 0],
    ]);
  });
});

describe('shapes to begin with', () => {
  test('a foot has a flat sole below all else', () => {
    const { points, kind, closed } = pathOfShape('foot');
    expect(kind).toBe('foot');
    expect(closed).toBe(true);
    const lowest = Math.min(...points.map(([, v]) => v));
    const sole = points.filter(([, v]) => v < lowest + 1e-9).map(([u]) => u);
    expect(Math.max(...sole) - Math.min(...sole)).toBeGreaterThan(7);
  });

  test('only a line is open', () => {
    expect(pathOfShape('line').closed).toBe(false);
    expect(pathOfShape('ellipse').closed).toBe(true);
  });
});

describe('a stroke', () => {
  const circle = (share: number) =>
    Array.from({ length: 40 }, (_, i) => {
      const angle = (2 * Math.PI * share * i) / 40;
      return [4 * Math.cos(angle), 4 * Math.sin(angle)] as const;
    });

  test('that ends near its begin is closed', () => {
    expect(comesBack(circle(1))).toBe(true);
  });

  test('that ends elsewhere is open', () => {
    expect(comesBack(circle(0.7))).toBe(false);
  });

  test('of a few points is open', () => {
    expect(comesBack([[0, 0]])).toBe(false);
  });
});
