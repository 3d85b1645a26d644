/**
 * Small vector and rotation arithmetic on tuples: world coordinates in modules (8 mm), Z up,
 * right-handed. Pure functions, no allocation beyond the result.
 */

/** A point or a direction: x, y, z in modules. */
export type Vec3 = readonly [number, number, number];

/** A rotation matrix, row-major; column j is the image of axis j. */
export type Mat3 = readonly [
  number,
  number,
  number,
  number,
  number,
  number,
  number,
  number,
  number,
];

/** A straight line between two points. */
export interface Segment {
  readonly from: Vec3;
  readonly to: Vec3;
}

/** A principal axis by its name, as sketch files write it. */
export type AxisName = 'x' | 'y' | 'z';

export const AXIS_NAMES: readonly AxisName[] = ['x', 'y', 'z'];

export const IDENTITY: Mat3 = [1, 0, 0, 0, 1, 0, 0, 0, 1];

export const ORIGIN: Vec3 = [0, 0, 0];

export function add(a: Vec3, b: Vec3): Vec3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function subtract(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function scale(a: Vec3, s: number): Vec3 {
  return [a[0] * s, a[1] * s, a[2] * s];
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function length(a: Vec3): number {
  return Math.sqrt(dot(a, a));
}

export function distance(a: Vec3, b: Vec3): number {
  return length(subtract(a, b));
}

/** The unit vector along a. @throws never: the zero vector gives itself. */
export function normalize(a: Vec3): Vec3 {
  const size = length(a);
  return size > 0 ? scale(a, 1 / size) : a;
}

/** The point at parameter t between a (0) and b (1). */
export function lerp(a: Vec3, b: Vec3, t: number): Vec3 {
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
}

/** m * v. */
export function rotate(m: Mat3, v: Vec3): Vec3 {
  return [
    m[0] * v[0] + m[1] * v[1] + m[2] * v[2],
    m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
    m[6] * v[0] + m[7] * v[1] + m[8] * v[2],
  ];
}

/** a * b: turns by b, then by a. */
export function multiply(a: Mat3, b: Mat3): Mat3 {
  const column = (j: 0 | 1 | 2) =>
    rotate(a, [b[j], b[(j + 3) as 3 | 4 | 5], b[(j + 6) as 6 | 7 | 8]]);
  const [x, y, z] = [column(0), column(1), column(2)];
  return [x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]];
}

/** True when the points differ by less than `tolerance` modules. */
export function samePoint(a: Vec3, b: Vec3, tolerance = 1e-6): boolean {
  return distance(a, b) < tolerance;
}

/** Unit vector of a principal axis. */
export function unitVector(axis: AxisName): Vec3 {
  if (axis === 'x') {
    return [1, 0, 0];
  }
  return axis === 'y' ? [0, 1, 0] : [0, 0, 1];
}

/** Index (0, 1, 2) of a principal axis. */
export function axisIndex(axis: AxisName): 0 | 1 | 2 {
  return axis === 'x' ? 0 : axis === 'y' ? 1 : 2;
}

/** Index (0, 1, 2) of the component with the largest magnitude; the lowest index on a tie. */
export function dominantAxis(v: Vec3): 0 | 1 | 2 {
  const x = Math.abs(v[0]);
  const y = Math.abs(v[1]);
  const z = Math.abs(v[2]);
  if (x >= y && x >= z) {
    return 0;
  }
  return y >= z ? 1 : 2;
}
