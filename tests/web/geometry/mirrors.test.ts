import { expect, test } from 'vitest';
import { findMirrors, mirrorPoint } from '../../../web/src/geometry/mirrors.ts';
import type { Segment, Vec3 } from '../../../web/src/geometry/vec.ts';

const line = (from: Vec3, to: Vec3): Segment => ({ from, to });

/** A table of 8 by 4 with legs of 5. */
const TABLE: readonly Segment[] = [
  line([0, 0, 5], [8, 0, 5]),
  line([8, 0, 5], [8, 4, 5]),
  line([8, 4, 5], [0, 4, 5]),
  line([0, 4, 5], [0, 0, 5]),
  line([0, 0, 0], [0, 0, 5]),
  line([8, 0, 0], [8, 0, 5]),
  line([8, 4, 0], [8, 4, 5]),
  line([0, 4, 0], [0, 4, 5]),
];

test('a table has the two mirror planes through its middle', () => {
  expect(findMirrors(TABLE)).toEqual([
    { normal: [1, 0, 0], offset: 4 },
    { normal: [0, 1, 0], offset: 2 },
  ]);
});

test('with one leg moved inwards a table has none', () => {
  const lame = [...TABLE.slice(0, -1), line([1, 4, 0], [1, 4, 5])];
  expect(findMirrors(lame)).toEqual([]);
});

test('a square is mirrored across its diagonals too', () => {
  const square = [
    line([0, 0, 0], [6, 0, 0]),
    line([6, 0, 0], [6, 6, 0]),
    line([6, 6, 0], [0, 6, 0]),
    line([0, 6, 0], [0, 0, 0]),
  ];
  const normals = findMirrors(square).map((plane) => plane.normal.join());
  expect(normals).toEqual(['1,0,0', '0,1,0', '0,0,1', '1,1,0', '1,-1,0']);
});

test('one line may mirror onto two in a row', () => {
  const lines = [
    line([0, 0, 0], [0, 4, 0]),
    line([6, 0, 0], [6, 1, 0]),
    line([6, 1, 0], [6, 4, 0]),
  ];
  expect(findMirrors(lines)).toContainEqual({ normal: [1, 0, 0], offset: 3 });
});

test('mirroring a point twice gives it back', () => {
  const plane = { normal: [1, -1, 0], offset: 2.5 } as const;
  const point: Vec3 = [3, 1, 7];
  const twice = mirrorPoint(mirrorPoint(point, plane), plane);
  twice.forEach((value, k) => {
    expect(value).toBeCloseTo(point[k] ?? 0, 12);
  });
});
