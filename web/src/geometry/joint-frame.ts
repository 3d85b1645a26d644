import { add, cross, dot, length, normalize, scale, subtract, type Vec3 } from './vec.ts';

/** Where the angles of a joint are counted from: right-handed about its axis, 0 along `zero`. */
export interface JointFrame {
  readonly at: Vec3;
  /** Unit length. */
  readonly axis: Vec3;
  /** Unit length, square to the axis. */
  readonly zero: Vec3;
}

const DEGREES = 180 / Math.PI;

/** @param along where what moves lies from the joint; any length, also along the axis. */
export function jointFrame(at: Vec3, axis: Vec3, along: Vec3): JointFrame {
  const unit = normalize(axis);
  const flat = subtract(along, scale(unit, dot(along, unit)));
  const zero = length(flat) > 1e-3 ? normalize(flat) : anyAcross(unit);
  return { at, axis: unit, zero };
}

/** The point of the ring at an angle in degrees. */
export function onRing({ at, axis, zero }: JointFrame, degrees: number, radius: number): Vec3 {
  const angle = degrees / DEGREES;
  const side = cross(axis, zero);
  const out = add(scale(zero, Math.cos(angle)), scale(side, Math.sin(angle)));
  return add(at, scale(out, radius));
}

/** The angle of a point, degrees above -180 and up to 180; 0 for points on the axis. */
export function angleOf({ at, axis, zero }: JointFrame, point: Vec3): number {
  const out = subtract(point, at);
  const angle = Math.atan2(dot(out, cross(axis, zero)), dot(out, zero)) * DEGREES;
  return angle <= -180 ? 180 : angle;
}

/**
 * An end of a range that is dragged to an angle: it stays on its side of 0 and does not leap from one end to the
 * other.
 * @param sign 1 for the upper end, -1 for the lower.
 * @param before where the end was.
 */
export function draggedEnd(sign: 1 | -1, before: number, angle: number): number {
  const along = sign * angle;
  if (along >= 0) {
    return angle;
  }
  // Beyond the half turn it stays there, below nothing at nothing.
  return Math.abs(before) > 90 ? sign * 180 : 0;
}

function anyAcross(axis: Vec3): Vec3 {
  return normalize(cross(axis, Math.abs(axis[2]) > 0.9 ? [0, 1, 0] : [0, 0, -1]));
}
