import { add, type Mat3, multiply, rotate, subtract } from '../geometry/vec.ts';
import { type MotionPath, type MovedPart, poseAt, posesAt } from './motion.ts';

// Several motions of one model at once.

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

/** Where one part stands under several motions that can be had together; null where none moves it. */
export function mixedPose(driven: readonly Driven[], part: number): MovedPart | null {
  const order = outerFirst(driven.map(({ path }) => path)).reverse();
  let result: MovedPart | null = null;
  for (const path of order) {
    const i = path.parts.indexOf(part);
    const degrees = driven.find((each) => each.path === path)?.degrees ?? 0;
    const [start, pose] = i < 0 ? [] : [poseAt(path, 0, i), poseAt(path, degrees, i)];
    if (start && pose) {
      result = after(displacement(start, pose), result ?? start);
    }
  }
  return result;
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
export function displacement(start: MovedPart, now: MovedPart): MovedPart {
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

export function transposed(m: Mat3): Mat3 {
  return [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];
}
