/**
 * Points and directions as tuples of modules (8 mm), Z up, right-handed: what the geometry of drawing
 * needs, below everything that knows of sketches.
 */

export type Vec3 = readonly [number, number, number];

/** A principal axis. */
export type Axis = 'x' | 'y' | 'z';

/** A straight line between two points. */
export interface Segment {
  readonly from: Vec3;
  readonly to: Vec3;
}

export const AXES: readonly Axis[] = ['x', 'y', 'z'];

export function add(a: Vec3, b: Vec3): Vec3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function subtract(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function scale(a: Vec3, factor: number): Vec3 {
  return [a[0] * factor, a[1] * factor, a[2] * factor];
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function length(a: Vec3): number {
  return Math.sqrt(dot(a, a));
}

export function distance(a: Vec3, b: Vec3): number {
  return length(subtract(a, b));
}

export function unitVector(axis: Axis): Vec3 {
  return [axis === 'x' ? 1 : 0, axis === 'y' ? 1 : 0, axis === 'z' ? 1 : 0];
}

/** 0, 1 or 2. */
export function axisIndex(axis: Axis): 0 | 1 | 2 {
  return axis === 'x' ? 0 : axis === 'y' ? 1 : 2;
}

/** The point a share of the way from `from` (0) to `to` (1). */
export function between(segment: Segment, share: number): Vec3 {
  const { from, to } = segment;
  return [
    from[0] + (to[0] - from[0]) * share,
    from[1] + (to[1] - from[1]) * share,
    from[2] + (to[2] - from[2]) * share,
  ];
}
