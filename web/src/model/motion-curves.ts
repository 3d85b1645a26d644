import { cross, dot, length, normalize, rotate, subtract, type Vec3 } from '../geometry/vec.ts';
import type { Catalogue } from './catalogue.ts';
import type { GearTrain } from './gear-motion.ts';
import type { Model } from './model.ts';
import type { MovedPart } from './motion.ts';
import { pointOf } from './motion-follow.ts';
import { type Driven, displacement, mixedPose, transposed } from './motion-mix.ts';
import { isFullTurn, spanOf } from './motion-span.ts';
import type { SketchJoint } from './sketch.ts';

// What a motion draws: the ways of points, and the angles of joints over time.

/** A point of one part, in the part's own frame. */
export interface TracePoint {
  readonly part: number;
  readonly local: Vec3;
}

/** How a motion is gone through. */
export interface Course {
  /** What moves, the one that is gone through first; the others stand. */
  readonly driven: readonly Driven[];
  readonly mode: 'loop' | 'swing';
  readonly degreesPerSecond: number;
}

/** One moment of a course. */
export interface Moment {
  /** Seconds from its beginning. */
  readonly second: number;
  readonly driven: readonly Driven[];
}

const NO_PATH = { angles: [] };
/** The moments of a course are so many degrees apart. */
const STEP = 3;

/** Seconds after which a course begins anew: a full turn, or there and back. */
export function periodOf({ driven, mode, degreesPerSecond }: Course): number {
  const [lead] = driven;
  const span = spanOf(lead?.path ?? NO_PATH);
  const once = mode === 'loop' && isFullTurn(span) ? 1 : 2;
  return (once * (span.to - span.from)) / degreesPerSecond;
}

/** The angle of the first driver at a second of a course. */
export function degreesAt(course: Course, second: number): number {
  const [lead] = course.driven;
  const span = spanOf(lead?.path ?? NO_PATH);
  const gone = second * course.degreesPerSecond;
  const size = span.to - span.from;
  return gone <= size ? span.from + gone : span.from + 2 * size - gone;
}

/** The moments of one period, the first and the last among them. */
export function momentsOf(course: Course): Moment[] {
  const [lead, ...others] = course.driven;
  const period = periodOf(course);
  if (!lead || period <= 0) {
    return [];
  }
  const count = Math.ceil((period * course.degreesPerSecond) / STEP);
  return Array.from({ length: count + 1 }, (_, i) => {
    const second = (period * i) / count;
    return { second, driven: [{ ...lead, degrees: degreesAt(course, second) }, ...others] };
  });
}

/** Where a point is at some moments. */
export function traceOf(
  model: Model,
  { part, local }: TracePoint,
  moments: readonly Moment[],
): Vec3[] {
  const rest = model.parts[part];
  return rest ? moments.map(({ driven }) => pointOf(mixedPose(driven, part) ?? rest, local)) : [];
}

/** Two bodies that turn against each other, each by one of its parts. */
export interface TurningPair {
  readonly axis: Vec3;
  readonly parts: readonly [number, number];
}

/** Two bodies at a joint. */
export interface JointPair extends TurningPair {
  /** Of the sketch. */
  readonly joint: number;
}

/** A shaft and what it turns in. */
export interface ShaftPair extends TurningPair {
  /** Of the sketch. */
  readonly shaft: number;
}

/** The shafts of the drawing, each against the largest body of the model. */
export function shaftPairs(trains: readonly GearTrain[], groups: readonly number[]): ShaftPair[] {
  const sizes = new Map<number, number>();
  for (const group of groups) {
    sizes.set(group, (sizes.get(group) ?? 0) + 1);
  }
  const [largest] = [...sizes].sort(([, a], [, b]) => b - a)[0] ?? [];
  const frame = largest === undefined ? -1 : groups.indexOf(largest);
  return trains
    .flatMap(({ shafts }) => shafts)
    .flatMap(({ drawn, axis, parts: [part] }) =>
      drawn === null || part === undefined || frame < 0
        ? []
        : [{ shaft: drawn, axis, parts: [frame, part] as const }],
    )
    .sort((a, b) => a.shaft - b.shaft);
}

/** How far beside a joint's axis a hole may lie that is on it, and how far along it, modules. */
const ON_AXIS = 0.05;
const ALONG_AXIS = 4;

/** The bodies that turn against each other at each joint: the largest two of those that have a hole on its axis. */
export function jointPairs(
  model: Model,
  catalogue: Catalogue,
  asked: { readonly joints: readonly SketchJoint[]; readonly groups: readonly number[] },
): JointPair[] {
  const sizes = new Map<number, number>();
  for (const group of asked.groups) {
    sizes.set(group, (sizes.get(group) ?? 0) + 1);
  }
  return asked.joints.flatMap(({ at, axis }, joint) => {
    const direction = normalize(axis);
    const found = new Map<number, number>();
    model.parts.forEach((placed, index) => {
      const group = asked.groups[index];
      const features = catalogue.find(placed.part)?.features ?? [];
      const on = features.some(
        (feature) =>
          feature.kind.endsWith('Hole') &&
          isOnAxis(
            { at: pointOf(placed, feature.center), along: rotate(placed.rotation, feature.axis) },
            { at, along: direction },
          ),
      );
      if (on && group !== undefined && !found.has(group)) {
        found.set(group, index);
      }
    });
    const [a, b] = [...found].sort(([g], [h]) => (sizes.get(h) ?? 0) - (sizes.get(g) ?? 0));
    return a && b ? [{ joint, axis: direction, parts: [a[1], b[1]] as const }] : [];
  });
}

interface Ray {
  readonly at: Vec3;
  /** Unit length. */
  readonly along: Vec3;
}

function isOnAxis(hole: Ray, axis: Ray): boolean {
  const from = subtract(hole.at, axis.at);
  const parallel = length(cross(hole.along, axis.along)) < ON_AXIS;
  const beside = length(cross(from, axis.along));
  return parallel && beside < ON_AXIS && Math.abs(dot(from, axis.along)) <= ALONG_AXIS;
}

/** The angle of a joint at some moments, degrees from the drawn pose, without leaps at half a turn. */
export function anglesOf(model: Model, pair: TurningPair, moments: readonly Moment[]): number[] {
  const turns = moments.map(({ driven }) => turnOf(model, pair, driven));
  let before = turns[0] ?? 0;
  return turns.map((turn) => {
    before = turn + 360 * Math.round((before - turn) / 360);
    return before;
  });
}

function turnOf(model: Model, { axis, parts }: TurningPair, driven: readonly Driven[]): number {
  const [a, b] = parts.map((part) => {
    const rest: MovedPart | undefined = model.parts[part];
    return rest && displacement(rest, mixedPose(driven, part) ?? rest).rotation;
  });
  if (!a || !b) {
    return 0;
  }
  // The one body's turn as the other one sees it.
  const back = transposed(a);
  const seen = (v: Vec3) => rotate(back, rotate(b, v));
  const aside = normalize(cross(axis, Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]));
  const image = seen(aside);
  return (Math.atan2(dot(cross(aside, image), axis), dot(aside, image)) * 180) / Math.PI;
}

/** The middles of the holes of a part, in its own frame. */
export function holesOf(catalogue: Catalogue, id: string): readonly Vec3[] {
  return (catalogue.find(id)?.features ?? [])
    .filter(({ kind }) => kind.endsWith('Hole'))
    .flatMap(({ slots, center }) => (slots.length > 0 ? slots : [center]));
}

/** The hole of a part that is nearest to a place on its surface: its middle, in the part's own frame; or null. */
export function nearestHole(
  catalogue: Catalogue,
  placed: { readonly part: string },
  local: Vec3,
): Vec3 | null {
  const middles = holesOf(catalogue, placed.part);
  const off = (p: Vec3) => length(subtract(p, local));
  const [first, ...rest] = middles;
  return first ? rest.reduce((best, p) => (off(p) < off(best) ? p : best), first) : null;
}
