import { type AxisName, dot, subtract, unitVector, type Vec3 } from '../model/vec.ts';
import type { GuidePlane, Ray } from '../view/view-types.ts';
import type { PlaneMode } from './tool.ts';

/** A level plane is what most people expect; an upright one must be seen clearly better to win. */
const LEVEL_PREFERENCE = 1.6;

const ORDER: readonly PlaneMode[] = ['auto', 'z', 'x', 'y'];

/** The plane mode that follows, round and round. */
export function nextPlaneMode(mode: PlaneMode): PlaneMode {
  return ORDER[(ORDER.indexOf(mode) + 1) % ORDER.length] ?? 'auto';
}

/** The normal axis of the plane to draw on, for a view direction of unit length. */
export function planeAxis(mode: PlaneMode, viewDirection: Vec3): AxisName {
  if (mode !== 'auto') {
    return mode;
  }
  const x = Math.abs(viewDirection[0]);
  const y = Math.abs(viewDirection[1]);
  const z = Math.abs(viewDirection[2]) * LEVEL_PREFERENCE;
  if (z >= x && z >= y) {
    return 'z';
  }
  return x > y ? 'x' : 'y';
}

/** Where a ray meets a plane, or null when it runs along it or away from it. */
export function meetPlane(ray: Ray, plane: GuidePlane): Vec3 | null {
  const normal = unitVector(plane.axis);
  const slope = dot(ray.direction, normal);
  if (Math.abs(slope) < 1e-4) {
    return null;
  }
  const t = dot(subtract(plane.through, ray.origin), normal) / slope;
  if (t < 0) {
    return null;
  }
  const { origin, direction } = ray;
  return [origin[0] + t * direction[0], origin[1] + t * direction[1], origin[2] + t * direction[2]];
}

/** The two axes of a plane, in the order x, y, z. */
export function planeAxes(normal: AxisName): readonly [AxisName, AxisName] {
  if (normal === 'x') {
    return ['y', 'z'];
  }
  return normal === 'y' ? ['x', 'z'] : ['x', 'y'];
}

/** The nearest whole coordinates; the one along the plane's normal stays. */
export function roundOnPlane(p: Vec3, plane: GuidePlane): Vec3 {
  const fixed = plane.axis === 'x' ? 0 : plane.axis === 'y' ? 1 : 2;
  const value = (k: number) => (k === fixed ? (plane.through[k] ?? 0) : Math.round(p[k] ?? 0));
  return [value(0), value(1), value(2)];
}
