import { Vector3 } from 'three';
import type { Vec3 } from '../../geometry/vec.ts';

/** Vertical opening of the perspective camera, degrees. */
export const FIELD_OF_VIEW = 26;

/** Space left beside what is fitted, and above and below it, as factors. */
export interface Margins {
  readonly across: number;
  readonly up: number;
}

const EVEN: Margins = { across: 1.14, up: 1.14 };
/** On the page, bars float over the upper and the lower edge of the picture. */
export const PAGE_MARGINS: Margins = { across: 1.14, up: 1.34 };
const NEAREST = 4;
const FARTHEST = 1500;
/** Each round centres the picture better; the third changes it by less than a pixel. */
const ROUNDS = 3;

/**
 * Where to look and from how far so that all points just fill the picture.
 * @param direction unit vector from the target to the eye, not along z.
 * @param aspect width divided by height of the picture.
 */
export function fitPoints(
  points: readonly Vec3[],
  direction: Vector3,
  aspect: number,
  margins: Margins = EVEN,
): { target: Vector3; away: number } {
  const right = new Vector3(0, 0, 1).cross(direction).normalize();
  const up = direction.clone().cross(right).normalize();
  const slope = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
  const target = centroid(points);
  let away: number = NEAREST;
  for (let round = 0; round < ROUNDS; round++) {
    const seen = points.map((point) => {
      const offset = new Vector3(...point).sub(target);
      return { u: offset.dot(right), v: offset.dot(up), depth: offset.dot(direction) };
    });
    away = NEAREST;
    for (const { u, v, depth } of seen) {
      const reach = Math.max((Math.abs(u) * margins.across) / aspect, Math.abs(v) * margins.up);
      away = Math.max(away, reach / slope + depth);
    }
    const shift = offCentre(seen, away);
    target.addScaledVector(right, shift.u).addScaledVector(up, shift.v);
  }
  return { target, away: Math.min(away, FARTHEST) };
}

function centroid(points: readonly Vec3[]): Vector3 {
  const min = new Vector3(Infinity, Infinity, Infinity);
  const max = min.clone().negate();
  for (const point of points) {
    min.min(new Vector3(...point));
    max.max(new Vector3(...point));
  }
  return points.length > 0 ? min.add(max).multiplyScalar(0.5) : new Vector3();
}

interface Seen {
  readonly u: number;
  readonly v: number;
  readonly depth: number;
}

/** How far the middle of the picture is off the middle of what is seen, at the target's depth. */
function offCentre(seen: readonly Seen[], away: number): { u: number; v: number } {
  const middle = (pick: (point: Seen) => number): number => {
    const values = seen.map((point) => (pick(point) * away) / Math.max(1e-3, away - point.depth));
    return values.length > 0 ? (Math.min(...values) + Math.max(...values)) / 2 : 0;
  };
  return { u: middle((point) => point.u), v: middle((point) => point.v) };
}
