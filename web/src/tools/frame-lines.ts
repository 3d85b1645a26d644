import {
  type AxisName,
  add,
  axisIndex,
  scale,
  subtract,
  unitVector,
  type Vec3,
} from '../geometry/vec.ts';
import type { SketchLine } from '../model/sketch.ts';
import { planeAxes } from './guide.ts';

/** Two points as a line; the order in which figures are made of. */
export type Segment = readonly [Vec3, Vec3];

/** The segments that are not single points, as lines of a sketch. */
export function toLines(segments: readonly Segment[]): SketchLine[] {
  return segments
    .filter(([a, b]) => a.some((value, k) => Math.abs(value - (b[k] ?? 0)) > 1e-6))
    .map(([from, to]) => ({ from, to }));
}

/** The four sides of the rectangle with opposite corners `a` and `b` on a plane. */
export function rectangle(a: Vec3, b: Vec3, normal: AxisName): Segment[] {
  const [first] = planeAxes(normal);
  const u = along(first, subtract(b, a));
  const v = subtract(subtract(b, a), u);
  const c1 = add(a, u);
  const c3 = add(a, v);
  return [
    [a, c1],
    [c1, b],
    [b, c3],
    [c3, a],
  ];
}

/** The twelve edges of a box: base corners `a` and `b`, and a height along the normal. */
export function boxFrame(a: Vec3, b: Vec3, normal: AxisName, height: number): Segment[] {
  const base = rectangle(a, b, normal);
  const up = scale(unitVector(normal), height);
  const top = base.map(([p, q]): Segment => [add(p, up), add(q, up)]);
  const posts = base.map(([p]): Segment => [p, add(p, up)]);
  return [...base, ...top, ...posts];
}

/** Lines of a grid over a rectangle, `cell` modules apart; the last cell may be narrower. */
export function gridLines(a: Vec3, b: Vec3, normal: AxisName, cell: number): Segment[] {
  const [first, second] = planeAxes(normal);
  const u = along(first, subtract(b, a));
  const v = along(second, subtract(b, a));
  return [...rows(a, u, v, cell), ...rows(a, v, u, cell)];
}

/** The six sides of a regular hexagon with a corner at a whole distance along the first axis. */
export function hexagon(centre: Vec3, side: number, normal: AxisName): Segment[] {
  const [first, second] = planeAxes(normal);
  const corner = (k: number): Vec3 => {
    const angle = (k * Math.PI) / 3;
    const u = scale(unitVector(first), side * Math.cos(angle));
    return add(centre, add(u, scale(unitVector(second), side * Math.sin(angle))));
  };
  return [0, 1, 2, 3, 4, 5].map((k): Segment => [corner(k), corner((k + 1) % 6)]);
}

function rows(a: Vec3, run: Vec3, across: Vec3, cell: number): Segment[] {
  const width = Math.round(Math.hypot(...across));
  if (width === 0) {
    return [[a, add(a, run)]];
  }
  const steps: number[] = [];
  for (let at = 0; at < width; at += cell) {
    steps.push(at);
  }
  steps.push(width);
  return steps.map((at): Segment => {
    const from = add(a, scale(across, at / width));
    return [from, add(from, run)];
  });
}

function along(axis: AxisName, d: Vec3): Vec3 {
  return scale(unitVector(axis), d[axisIndex(axis)]);
}
