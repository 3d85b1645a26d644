import { add, dot, type Mat3, normalize, rotate, subtract, type Vec3 } from '../geometry/vec.ts';
import { type MotionPath, type MovedPart, posesAt } from './motion.ts';

// Several motions of one model at once, and what can be read off them.

/** A motion and where it stands. */
export interface Driven {
  readonly path: MotionPath;
  readonly degrees: number;
}

/** Modules and sines: key poses are rounded to six decimals. */
const SAME = 1e-3;

/**
 * Whether motions can be had together: each two move different parts, or one carries all that the other moves as one
 * rigid body, as a turntable carries an arm. Motions of one closed chain cannot: there one angle settles the other.
 */
export function canMix(paths: readonly MotionPath[]): boolean {
  const sorted = outerFirst(paths);
  return sorted.every((outer, i) =>
    sorted.slice(i + 1).every((inner) => isApart(outer, inner) || carries(outer, inner)),
  );
}

/** Where the parts stand under several motions that can be had together. */
export function mixedPoses(driven: readonly Driven[]): Map<number, MovedPart> {
  const [only, ...more] = driven;
  if (!only) {
    return new Map();
  }
  if (more.length === 0) {
    return posesAt(only.path, only.degrees);
  }
  const order = outerFirst(driven.map(({ path }) => path));
  const result = new Map<number, MovedPart>();
  // From the inner ones outwards: what carries moves what has moved by itself.
  for (const path of [...order].reverse()) {
    const degrees = driven.find((each) => each.path === path)?.degrees ?? 0;
    const rest = posesAt(path, 0);
    for (const [part, pose] of posesAt(path, degrees)) {
      const start = rest.get(part);
      if (start) {
        result.set(part, after(displacement(start, pose), result.get(part) ?? start));
      }
    }
  }
  return result;
}

/** The place of a point of a part, given where the model has it. */
export function carriedPoint(start: MovedPart, now: MovedPart, point: Vec3): Vec3 {
  const move = displacement(start, now);
  return add(rotate(move.rotation, point), move.position);
}

/**
 * How far two parts have turned against each other about an axis, at each key of a motion: degrees, without leaps.
 * @param axis in the drawn pose, fixed to the first part.
 */
export function turnsBetween(
  path: MotionPath,
  parts: readonly [number, number],
  axis: Vec3,
): number[] {
  const rest = posesAt(path, 0);
  const unit = normalize(axis);
  const turns = path.angles.map((degrees) => {
    const poses = posesAt(path, degrees);
    const move = (part: number) => {
      const [start, now] = [rest.get(part), poses.get(part)];
      return start && now ? displacement(start, now).rotation : null;
    };
    const [a, b] = [move(parts[0]), move(parts[1])];
    const relative = product(a ? transposed(a) : null, b);
    return relative ? angleAbout(relative, unit) : 0;
  });
  // The drawn pose is 0; from there the angle goes on from key to key.
  const zero = path.angles.findIndex((angle) => angle >= 0);
  for (let i = zero + 1; i < turns.length; i++) {
    turns[i] = nearestTurn(turns[i] ?? 0, turns[i - 1] ?? 0);
  }
  for (let i = zero - 1; i >= 0; i--) {
    turns[i] = nearestTurn(turns[i] ?? 0, turns[i + 1] ?? 0);
  }
  return turns;
}

function outerFirst(paths: readonly MotionPath[]): MotionPath[] {
  return [...paths].sort((a, b) => b.parts.length - a.parts.length);
}

function isApart(a: MotionPath, b: MotionPath): boolean {
  const moved = new Set(a.parts);
  return !b.parts.some((part) => moved.has(part));
}

/** Whether all that `inner` moves is moved as one body by `outer`, which moves more. */
function carries(outer: MotionPath, inner: MotionPath): boolean {
  const moved = new Set(outer.parts);
  if (inner.parts.length >= outer.parts.length || !inner.parts.every((part) => moved.has(part))) {
    return false;
  }
  const rest = posesAt(outer, 0);
  return outer.angles.every((degrees) => {
    const poses = posesAt(outer, degrees);
    const moves = inner.parts.flatMap((part) => {
      const [start, now] = [rest.get(part), poses.get(part)];
      return start && now ? [displacement(start, now)] : [];
    });
    const [first] = moves;
    return first !== undefined && moves.every((move) => isSame(move, first));
  });
}

/** What takes a part from one place to another: p -> rotation p + position. */
function displacement(start: MovedPart, now: MovedPart): MovedPart {
  const rotation = multiply(now.rotation, transposed(start.rotation));
  return { rotation, position: subtract(now.position, rotate(rotation, start.position)) };
}

function after(outer: MovedPart, inner: MovedPart): MovedPart {
  return {
    rotation: multiply(outer.rotation, inner.rotation),
    position: add(rotate(outer.rotation, inner.position), outer.position),
  };
}

function isSame(a: MovedPart, b: MovedPart): boolean {
  const near = (x: number, i: number, other: readonly number[]) =>
    Math.abs(x - (other[i] ?? 0)) < SAME * 10;
  return (
    a.rotation.every((x, i) => near(x, i, b.rotation)) &&
    a.position.every((x, i) => near(x, i, b.position))
  );
}

function product(a: Mat3 | null, b: Mat3 | null): Mat3 | null {
  return a && b ? multiply(a, b) : (a ?? b);
}

function multiply(a: Mat3, b: Mat3): Mat3 {
  const column = (j: 0 | 1 | 2) =>
    rotate(a, [b[j], b[(j + 3) as 3 | 4 | 5], b[(j + 6) as 6 | 7 | 8]]);
  const [x, y, z] = [column(0), column(1), column(2)];
  return [x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]];
}

function transposed(m: Mat3): Mat3 {
  return [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];
}

/** The part of a rotation that turns about an axis, degrees. */
function angleAbout(m: Mat3, axis: Vec3): number {
  const twist = dot([m[7] - m[5], m[2] - m[6], m[3] - m[1]], axis);
  return (Math.atan2(twist, m[0] + m[4] + m[8] - 1) * 180) / Math.PI;
}

function nearestTurn(angle: number, to: number): number {
  return angle + 360 * Math.round((to - angle) / 360);
}
