import type { Vec3 } from '../geometry/vec.ts';
import type { Feature, Part } from './catalogue.ts';

/** A plane of a part's own frame, across an axis (0 to 2), at a coordinate on it. */
export interface MirrorPlane {
  readonly axis: 0 | 1 | 2;
  readonly at: number;
}

/**
 * A plane that takes a part to itself: its holes, its heads and its box to their images. Such a part may be placed as a
 * mirror image, which is one of its own poses.
 */
export function mirrorPlane(part: Part): MirrorPlane | null {
  for (const axis of [0, 1, 2] as const) {
    const at = (part.boundsMin[axis] + part.boundsMax[axis]) / 2;
    const keys = new Set(part.features.map((feature) => keyOf(feature)));
    if (part.features.every((feature) => keys.has(keyOf(mirrored(feature, axis, at))))) {
      return { axis, at };
    }
  }
  return null;
}

function mirrored(feature: Feature, axis: 0 | 1 | 2, at: number): Feature {
  const flip = (v: Vec3, about: number): Vec3 => [
    axis === 0 ? 2 * about - v[0] : v[0],
    axis === 1 ? 2 * about - v[1] : v[1],
    axis === 2 ? 2 * about - v[2] : v[2],
  ];
  return { ...feature, center: flip(feature.center, at), axis: flip(feature.axis, 0) };
}

/** A stretch has no direction. */
function keyOf({ kind, center, axis, length }: Feature): string {
  const lead = axis.find((x) => Math.abs(x) > 1e-6) ?? 1;
  const numbers = [...center, ...axis.map((x) => x * Math.sign(lead)), length];
  return `${kind} ${numbers.map((x) => (Math.round(x * 100) / 100 + 0).toFixed(2)).join(' ')}`;
}
