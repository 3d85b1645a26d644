import { axesOf, meetPlane } from '../geometry/plane.ts';
import type { AxisName, Vec3 } from '../geometry/vec.ts';
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

/** Where a ray meets the plane, or null when it runs along it or away from it. */
export function meetGuide(ray: Ray, plane: GuidePlane): Vec3 | null {
  return meetPlane(ray, { normal: plane.axis, through: plane.through });
}

/** The two axes along a plane, in the order x, y, z. */
export function planeAxes(normal: AxisName): readonly [AxisName, AxisName] {
  return axesOf({ normal, through: [0, 0, 0] });
}
