import { type AxisName, axisIndex, dot, subtract, unitVector, type Vec3 } from './vec.ts';

/** A plane across a principal axis. */
export interface Plane {
  readonly normal: AxisName;
  readonly through: Vec3;
}

/** A half-line; the direction has unit length. */
export interface Ray {
  readonly origin: Vec3;
  readonly direction: Vec3;
}

/** Rays flatter than this against a plane or along an axis meet it too far away to aim at. */
const GRAZING = 1e-4;

/** The two axes along the plane, in the order x, y, z. */
export function axesOf(plane: Plane): readonly [AxisName, AxisName] {
  if (plane.normal === 'x') {
    return ['y', 'z'];
  }
  return plane.normal === 'y' ? ['x', 'z'] : ['x', 'y'];
}

/** Where a ray meets a plane, or null when it runs along it or away from it. */
export function meetPlane(ray: Ray, plane: Plane): Vec3 | null {
  const k = axisIndex(plane.normal);
  const slope = ray.direction[k];
  if (Math.abs(slope) < GRAZING) {
    return null;
  }
  const t = (plane.through[k] - ray.origin[k]) / slope;
  if (t < 0) {
    return null;
  }
  const point: [number, number, number] = [
    ray.origin[0] + t * ray.direction[0],
    ray.origin[1] + t * ray.direction[1],
    ray.origin[2] + t * ray.direction[2],
  ];
  point[k] = plane.through[k];
  return point;
}

/** The point of the plane below or above `point`. */
export function projectToPlane(point: Vec3, plane: Plane): Vec3 {
  const k = axisIndex(plane.normal);
  const projected: [number, number, number] = [...point];
  projected[k] = plane.through[k];
  return projected;
}

/**
 * How many modules from `start` along an axis the axis comes nearest to a ray, or null when the two
 * are almost parallel.
 */
export function nearestAlongAxis(ray: Ray, start: Vec3, axis: AxisName): number | null {
  const along = unitVector(axis);
  const offset = subtract(start, ray.origin);
  const cosine = dot(along, ray.direction);
  const sineSquared = 1 - cosine * cosine;
  if (sineSquared < GRAZING) {
    return null;
  }
  return (cosine * dot(offset, ray.direction) - dot(offset, along)) / sineSquared;
}
