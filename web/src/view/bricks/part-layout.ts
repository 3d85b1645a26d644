import {
  add,
  distance,
  dot,
  length,
  normalize,
  samePoint,
  scale,
  subtract,
  type Vec3,
} from '../../geometry/vec.ts';
import { type Feature, isHole, isMale, type Part, type Prism } from '../../model/catalogue.ts';
import { bodyPrisms, distanceToSegment, isPoint, parallel, TOLERANCE } from './body-prisms.ts';

/** One place of a body, a module wide: its middle and the axis about which it is round. */
export interface BodyCell {
  readonly at: Vec3;
  readonly axis: Vec3;
  readonly radius: number;
  readonly halfHeight: number;
}

/** Cells of one axis and height that make one flat body: a beam, or one barrel of a connector. */
export interface BodyGroup {
  readonly axis: Vec3;
  readonly radius: number;
  readonly halfHeight: number;
  /** Points of the body's middle plane. */
  readonly points: readonly Vec3[];
  /** Pairs of point indices joined by straight bars. */
  readonly bars: readonly (readonly [number, number])[];
  readonly cells: readonly BodyCell[];
  readonly holes: readonly Feature[];
}

/**
 * Two neighbouring cells whose axes cross. `web`: the way between them is across both axes. `neck`:
 * `b` stands upright on the side of `a`.
 */
export interface Bridge {
  readonly kind: 'web' | 'neck';
  readonly a: BodyCell;
  readonly b: BodyCell;
}

/** A head or an axle and what it stands on at either end of its axis. */
export interface MaleRun {
  readonly feature: Feature;
  /** The cell that the end at -axis (0) and at +axis (1) grows from, if any. */
  readonly roots: readonly [BodyCell | null, BodyCell | null];
  /** Another male stretch goes on there. */
  readonly joined: readonly [boolean, boolean];
}

/** What a part consists of, for drawing. */
export interface PartLayout {
  readonly groups: readonly BodyGroup[];
  readonly bridges: readonly Bridge[];
  readonly males: readonly MaleRun[];
}

/** Finds the bodies, bridges and heads of a part from its catalogue entry. */
export function layOutPart(part: Part): PartLayout {
  const holes = part.features.filter((feature) => isHole(feature.kind));
  const groups = groupPrisms(bodyPrisms(part), holes);
  const cells = groups.flatMap((group) => group.cells);
  return {
    groups,
    bridges: findBridges(groups),
    males: findMales(part, cells),
  };
}

function groupPrisms(prisms: readonly Prism[], holes: readonly Feature[]): BodyGroup[] {
  const keyed = new Map<string, Prism[]>();
  for (const prism of prisms) {
    const key = [...prism.axis, dot(prism.from, prism.axis), prism.halfThickness, prism.radius]
      .map((value) => Math.round(value * 100))
      .map((value) => (value === 0 ? 0 : value))
      .join(',');
    keyed.set(key, [...(keyed.get(key) ?? []), prism]);
  }
  return [...keyed.values()].flatMap((level) => connectedGroups(level, holes));
}

/** Splits the prisms of one plane into connected figures. */
function connectedGroups(level: readonly Prism[], holes: readonly Feature[]): BodyGroup[] {
  const points = distinctPoints(level.flatMap((prism) => [prism.from, prism.to]));
  const bars = level.flatMap((prism) => barsAlong(prism, points));
  const lone = distinctPoints(level.filter(isPoint).map((prism) => prism.from));
  for (const a of lone) {
    for (const b of points) {
      if (Math.abs(distance(a, b) - 1) < TOLERANCE) {
        bars.push([indexOf(points, a), indexOf(points, b)]);
      }
    }
  }
  const first = level[0];
  return first
    ? components(points, bars).map((set) => toGroup(set, { points, bars, prism: first, holes }))
    : [];
}

/** The figure made of the points in `set`. */
function toGroup(
  set: readonly number[],
  level: {
    readonly points: readonly Vec3[];
    readonly bars: readonly (readonly [number, number])[];
    readonly prism: Prism;
    readonly holes: readonly Feature[];
  },
): BodyGroup {
  const { points, bars, prism, holes } = level;
  const own = set.map((index) => points[index] ?? prism.from);
  const ownBars = bars
    .filter(([a]) => set.includes(a))
    .map(([a, b]) => [set.indexOf(a), set.indexOf(b)] as const);
  const { axis, radius, halfThickness: halfHeight } = prism;
  const inside = holes.filter(
    (hole) => parallel(hole.axis, axis) && liesIn(hole, { own, ownBars, prism }),
  );
  const cells = cellPlaces(own, ownBars).map((at) => ({ at, axis, radius, halfHeight }));
  return { axis, radius, halfHeight, points: own, bars: ownBars, cells, holes: inside };
}

/** Modules: a disc wider than this, such as a wheel's, has holes beside its middle ... */
const WIDE = 1;
/** ... which end so far inside its rim. */
const HOLE_ROOM = 0.5;

function liesIn(
  hole: Feature,
  body: {
    readonly own: readonly Vec3[];
    readonly ownBars: readonly (readonly [number, number])[];
    readonly prism: Prism;
  },
): boolean {
  const { own, ownBars, prism } = body;
  const height = dot(subtract(hole.center, prism.from), prism.axis);
  if (Math.abs(height) > prism.halfThickness) {
    return false;
  }
  const flat = subtract(hole.center, scale(prism.axis, height));
  const near = own.length === 1 && prism.radius > WIDE ? prism.radius - HOLE_ROOM : 0.1;
  return (
    own.some((point) => distance(point, flat) < near) ||
    ownBars.some(([a, b]) => distanceToSegment(flat, own[a] ?? flat, own[b] ?? flat) < 0.1)
  );
}

/** Points one module apart along all bars, and the lone points. */
function cellPlaces(points: readonly Vec3[], bars: readonly (readonly [number, number])[]): Vec3[] {
  const places = [...points];
  for (const [i, j] of bars) {
    const a = points[i];
    const b = points[j];
    if (!a || !b) {
      continue;
    }
    const along = normalize(subtract(b, a));
    for (let t = 1; t < distance(a, b) - 0.5; t++) {
      places.push(add(a, scale(along, t)));
    }
  }
  return distinctPoints(places);
}

/** A prism's segment cut at every point of its level that lies on it. */
function barsAlong(prism: Prism, points: readonly Vec3[]): (readonly [number, number])[] {
  if (isPoint(prism)) {
    return [];
  }
  const on = points
    .filter((point) => distanceToSegment(point, prism.from, prism.to) < TOLERANCE)
    .sort((a, b) => distance(a, prism.from) - distance(b, prism.from))
    .map((point) => indexOf(points, point));
  return on.slice(1).map((to, i) => [on[i] ?? to, to] as const);
}

function components(
  points: readonly Vec3[],
  bars: readonly (readonly [number, number])[],
): number[][] {
  const label = points.map((_, i) => i);
  for (let changed = true; changed; ) {
    changed = false;
    for (const [a, b] of bars) {
      const low = Math.min(label[a] ?? a, label[b] ?? b);
      changed ||= label[a] !== low || label[b] !== low;
      label[a] = low;
      label[b] = low;
    }
  }
  return [...new Set(label)].map((name) =>
    points.map((_, i) => i).filter((i) => label[i] === name),
  );
}

function findBridges(groups: readonly BodyGroup[]): Bridge[] {
  const bridges: Bridge[] = [];
  groups.forEach((group, i) => {
    for (const other of groups.slice(i + 1)) {
      for (const a of group.cells) {
        for (const b of other.cells) {
          const bridge = bridgeBetween(a, b);
          if (bridge) {
            bridges.push(bridge);
          }
        }
      }
    }
  });
  return bridges;
}

function bridgeBetween(a: BodyCell, b: BodyCell): Bridge | null {
  const offset = subtract(b.at, a.at);
  if (length(offset) > 1.3 || parallel(a.axis, b.axis)) {
    return null;
  }
  if (standsOn(b, a)) {
    return { kind: 'neck', a, b };
  }
  if (standsOn(a, b)) {
    return { kind: 'neck', a: b, b: a };
  }
  const alongA = dot(offset, a.axis);
  const alongB = dot(offset, b.axis);
  const rest = subtract(offset, add(scale(a.axis, alongA), scale(b.axis, alongB)));
  const square = Math.abs(dot(a.axis, b.axis)) < 0.01;
  const near = Math.abs(alongA) < 0.6 && Math.abs(alongB) < 0.6;
  return square && near && length(rest) > 0.7 ? { kind: 'web', a, b } : null;
}

/** True when the foot of `barrel` touches the side of `body`. */
function standsOn(barrel: BodyCell, body: BodyCell): boolean {
  const offset = subtract(barrel.at, body.at);
  const gap = length(offset);
  return (
    parallel(normalize(offset), barrel.axis) &&
    Math.abs(dot(offset, body.axis)) < 0.1 &&
    Math.abs(gap - barrel.halfHeight - 0.5) < 0.15
  );
}

function findMales(part: Part, cells: readonly BodyCell[]): MaleRun[] {
  const males = part.features.filter((feature) => isMale(feature.kind));
  const end = (feature: Feature, side: -1 | 1): Vec3 =>
    add(feature.center, scale(feature.axis, (side * feature.length) / 2));
  return males.map((feature) => {
    const rootAt = (side: -1 | 1): BodyCell | null =>
      cells.find((cell) => growsFrom(cell, end(feature, side), scale(feature.axis, side))) ?? null;
    const joinedAt = (side: -1 | 1): boolean =>
      males.some(
        (other) =>
          other !== feature &&
          parallel(other.axis, feature.axis) &&
          ([-1, 1] as const).some((s) => samePoint(end(other, s), end(feature, side), TOLERANCE)),
      );
    return {
      feature,
      roots: [rootAt(-1), rootAt(1)] as const,
      joined: [joinedAt(-1), joinedAt(1)] as const,
    };
  });
}

/** True when a male stretch that ends at `tip`, looking along `outward`, stands on the cell. */
function growsFrom(cell: BodyCell, tip: Vec3, outward: Vec3): boolean {
  const reach = parallel(cell.axis, outward) ? cell.halfHeight : 0.5;
  return distance(cell.at, add(tip, scale(outward, reach))) < 0.15;
}

function indexOf(points: readonly Vec3[], point: Vec3): number {
  return points.findIndex((other) => samePoint(other, point, TOLERANCE));
}

function distinctPoints(points: readonly Vec3[]): Vec3[] {
  const distinct: Vec3[] = [];
  for (const point of points) {
    if (indexOf(distinct, point) < 0) {
      distinct.push(point);
    }
  }
  return distinct;
}
