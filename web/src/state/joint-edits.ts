import {
  AXIS_NAMES,
  type AxisName,
  cross,
  length,
  normalize,
  samePoint,
  unitVector,
  type Vec3,
} from '../geometry/vec.ts';
import { lineVector, type SketchDocument, type SketchJoint, versionOf } from '../model/sketch.ts';
import { passesNode } from './follow-lines.ts';
import { MAX_JOINT_BODIES } from './read-sketch.ts';

// Edits of one joint: its axis, what moves, how far it must turn. Functions from joint to joint or from
// sketch to sketch.

/** A joint of a sketch by its place: undo and other edits may shift its number. */
export interface JointPlace {
  readonly at: Vec3;
  /** Which of the joints there. */
  readonly nth: number;
}

/** Sine of the angle below which directions are one. */
const PARALLEL = 1e-3;

/** Numbers of the joints at a point. */
export function jointsAt(sketch: SketchDocument, at: Vec3): number[] {
  return (sketch.joints ?? []).flatMap((joint, i) => (samePoint(joint.at, at, 1e-3) ? [i] : []));
}

/** The number of the joint at a place, or null where there is none any more. */
export function jointIndex(sketch: SketchDocument, place: JointPlace | null): number | null {
  return place ? (jointsAt(sketch, place.at)[place.nth] ?? null) : null;
}

/** The place of a joint by its number; null where there is none. */
export function placeOfJoint(sketch: SketchDocument, index: number): JointPlace | null {
  const joint = sketch.joints?.[index];
  return joint ? { at: joint.at, nth: jointsAt(sketch, joint.at).indexOf(index) } : null;
}

/** Numbers of the lines with a node at a point. */
export function linesAt(sketch: SketchDocument, at: Vec3): number[] {
  return sketch.lines.flatMap((line, i) => (passesNode(line, at) ? [i] : []));
}

/** The bodies of a joint as lists of lines; where it names none, each of its two lines is one. */
export function bodiesOf(
  sketch: SketchDocument,
  joint: SketchJoint,
): readonly (readonly number[])[] {
  return joint.between ?? linesAt(sketch, joint.at).map((line) => [line]);
}

/** The principal axis that a joint turns about; null for any other direction. */
export function axisNameOf({ axis }: Pick<SketchJoint, 'axis'>): AxisName | null {
  return AXIS_NAMES.find((name) => isParallel(axis, unitVector(name))) ?? null;
}

/** The lines of a joint's node that lie along a principal axis: about it they would turn about themselves. */
export function linesAlong(sketch: SketchDocument, at: Vec3, axis: AxisName): number[] {
  return linesAt(sketch, at).filter((i) => {
    const line = sketch.lines[i];
    return line !== undefined && isParallel(lineVector(line), unitVector(axis));
  });
}

/**
 * The joint that is most likely meant at a point: lines of one direction turn against the others, about the axis
 * square to both; lines in a row fold. Null where fewer than two lines meet.
 */
export function likelyJoint(sketch: SketchDocument, at: Vec3): SketchJoint | null {
  const directions = linesAt(sketch, at).flatMap((index) => {
    const line = sketch.lines[index];
    return line ? [{ index, direction: normalize(lineVector(line)) }] : [];
  });
  const [first, ...rest] = directions;
  if (!first || rest.length === 0) {
    return null;
  }
  const parallel = ({ direction }: { direction: Vec3 }) => isParallel(direction, first.direction);
  const other = directions.find((each) => !parallel(each));
  if (!other) {
    const axis = unitVector(acrossOf(first.direction));
    return { at, axis, between: [[first.index], rest.map(({ index }) => index)] };
  }
  const axis = positive(normalize(cross(first.direction, other.direction)));
  if (directions.length === 2) {
    return { at, axis };
  }
  const indices = (group: typeof directions) => group.map(({ index }) => index);
  const rests = directions.filter((each) => !parallel(each));
  return { at, axis, between: [indices(directions.filter(parallel)), indices(rests)] };
}

/** One more joint for a point that has some: the lines that none of them names, or else another axis. */
export function furtherJoint(sketch: SketchDocument, at: Vec3): SketchJoint | null {
  const likely = likelyJoint(sketch, at);
  const there = jointsAt(sketch, at).flatMap((i) => sketch.joints?.[i] ?? []);
  const named = new Set(there.flatMap((joint) => bodiesOf(sketch, joint).flat()));
  const free = linesAt(sketch, at).filter((line) => !named.has(line));
  const [first, ...rest] = free;
  if (!likely || first === undefined) {
    return likely;
  }
  // A line alone turns against the first body of the joint that is there.
  const against = rest.length > 0 ? rest : (there[0] && bodiesOf(sketch, there[0])[0]) || [];
  const axis = there[0]?.axis ?? likely.axis;
  return against.length > 0 ? { at, axis, between: [against, [first]] } : likely;
}

/** The sketch with a joint at the end of its list. */
export function insertJoint(sketch: SketchDocument, joint: SketchJoint): SketchDocument {
  return withJoints(sketch, [...(sketch.joints ?? []), joint]);
}

/** The sketch with another joint in the place of one. */
export function replaceJoint(
  sketch: SketchDocument,
  index: number,
  joint: SketchJoint,
): SketchDocument {
  return withJoints(
    sketch,
    (sketch.joints ?? []).map((old, i) => (i === index ? joint : old)),
  );
}

/** The sketch without one of its joints. */
export function dropJoint(sketch: SketchDocument, index: number): SketchDocument {
  return withJoints(
    sketch,
    (sketch.joints ?? []).filter((_, i) => i !== index),
  );
}

/** The joint with a required range, degrees; null asks for none. */
export function withRange(
  joint: SketchJoint,
  range: readonly [number, number] | null,
): SketchJoint {
  const { range: _dropped, ...rest } = joint;
  return range ? { ...rest, range } : rest;
}

/**
 * The joint with a line in the next body: from body to body, then in one of its own, then in none, then in the
 * first. What would leave fewer than two bodies is left out. The same joint where nothing else can be.
 */
export function moveLine(sketch: SketchDocument, joint: SketchJoint, line: number): SketchJoint {
  const bodies = bodiesOf(sketch, joint);
  const now = bodies.findIndex((body) => body.includes(line));
  const without = bodies.map((body) => body.filter((each) => each !== line));
  const last = Math.min(bodies.length, MAX_JOINT_BODIES - 1);
  // Places from the one after the present one round to it; -1 is no body.
  const round = Array.from({ length: last + 2 }, (_, i) => ((now + 2 + i) % (last + 2)) - 1);
  for (const body of round) {
    const next = [...without, []]
      .map((lines, i) => (i === body ? [...lines, line].sort((a, b) => a - b) : lines))
      .filter((lines) => lines.length > 0);
    if (next.length >= 2 && JSON.stringify(next) !== JSON.stringify(bodies)) {
      return { ...joint, between: next };
    }
  }
  return joint;
}

/** A range as angles that a joint can be asked for: whole degrees, 0 among them; null where it has no extent. */
export function legalRange(from: number, to: number): readonly [number, number] | null {
  const low = Math.max(-180, Math.min(0, Math.round(from))) + 0;
  const high = Math.min(180, Math.max(0, Math.round(to))) + 0;
  return low < high ? [low, high] : null;
}

function withJoints(sketch: SketchDocument, joints: readonly SketchJoint[]): SketchDocument {
  const { joints: _dropped, ...rest } = sketch;
  const next = joints.length > 0 ? { ...rest, joints } : rest;
  return { ...next, version: versionOf(next) };
}

function isParallel(a: Vec3, b: Vec3): boolean {
  return length(cross(normalize(a), normalize(b))) < PARALLEL;
}

/** The first principal axis, z before y before x, that is square to a direction. */
function acrossOf(direction: Vec3): AxisName {
  const axes = [...AXIS_NAMES].reverse();
  return (
    axes.find((name) => length(cross(direction, unitVector(name))) > 1 - PARALLEL) ??
    (isParallel(direction, [0, 0, 1]) ? 'y' : 'z')
  );
}

/** The same line of direction, its first part that is not 0 above 0. */
function positive(axis: Vec3): Vec3 {
  const first = axis.find((value) => Math.abs(value) > PARALLEL) ?? 1;
  const sign = first < 0 ? -1 : 1;
  return [axis[0] * sign + 0, axis[1] * sign + 0, axis[2] * sign + 0];
}
