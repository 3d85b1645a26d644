import {
  axisDirections,
  type Direction,
  pythagoreanDirections,
  sixtyDirections,
  walk,
} from './directions.ts';
import { isPlanar, WHOLE, wholeLength } from './legal-line.ts';
import { type Plane, projectToPlane } from './plane.ts';
import {
  type AxisName,
  axisIndex,
  distance,
  dot,
  length,
  lerp,
  type Segment,
  scale,
  subtract,
  unitVector,
  type Vec3,
} from './vec.ts';

/** Why a point is where it is; shown beside it. */
export type SnapReason =
  | 'endpoint'
  | 'node'
  | 'axis'
  | 'plane'
  | 'parallel'
  | 'pythagorean'
  | 'sixty';

export interface SnapContext {
  /** Where the line begins, or null while its first point is sought. */
  readonly start: Vec3 | null;
  /** The guiding plane. A line from `start` lies in the parallel plane through it. */
  readonly plane: Plane;
  /** The lines drawn so far. */
  readonly lines: readonly Segment[];
  /** Only ends along this axis, or null. */
  readonly lockAxis: AxisName | null;
  /** Where the pointer is, on or near the plane. */
  readonly cursor: Vec3;
  /** How far, in modules, the pointer may be from what it is drawn to. */
  readonly tolerance: number;
}

export interface Snap {
  readonly point: Vec3;
  readonly reason: SnapReason;
  /** Whole, at least 1; 0 for a first point. */
  readonly length: number;
}

/** The share of its distance that counts: a strong reason wins over a nearer weak one. */
const PULL: Readonly<Record<SnapReason, number>> = {
  endpoint: 0.3,
  node: 0.45,
  axis: 0.55,
  parallel: 0.7,
  pythagorean: 0.8,
  sixty: 0.9,
  plane: 1,
};

/** Where nothing is within reach: nearly the nearest, so that no small move of the pointer makes a large one. */
const FAR_PULL: Readonly<Record<SnapReason, number>> = {
  endpoint: 0.7,
  node: 0.75,
  axis: 0.8,
  parallel: 0.95,
  pythagorean: 1,
  sixty: 1,
  plane: 1,
};

/**
 * The point that a pointer means, with the reason. A line's end has a whole length from its start and
 * shares with it one coordinate at least, always: ends that have not are not offered.
 */
export function snapEnd(context: SnapContext): Snap {
  if (context.start === null) {
    return snapFirst(context);
  }
  const line: Started = { ...context, start: context.start };
  const ways = context.lockAxis ? bothWays(context.lockAxis) : waysInPlane(line);
  const cursor = context.lockAxis
    ? context.cursor
    : projectToPlane(context.cursor, { normal: context.plane.normal, through: line.start });
  const all = [...nodeEnds(line), ...wayEnds(line, cursor, ways)];
  const near = all.filter(({ point, target }) => distance(point, target) <= context.tolerance);
  return cheapest(near, PULL) ?? cheapest(all, FAR_PULL) ?? firstAxisEnd(line, ways);
}

function cheapest(
  candidates: readonly Candidate[],
  pull: Readonly<Record<SnapReason, number>>,
): Snap | null {
  let best: Candidate | null = null;
  let bestCost = Infinity;
  for (const candidate of candidates) {
    const cost = distance(candidate.point, candidate.target) * pull[candidate.reason];
    if (cost < bestCost) {
      best = candidate;
      bestCost = cost;
    }
  }
  return best && { point: best.point, reason: best.reason, length: best.length };
}

/** As many are shown at most; the nearest to the pointer. */
const MOST_ENDS = 24;

/**
 * Where a line from the start may end on the plane, round the pointer: along axes, on slopes and at sixty degrees.
 * @param within modules from the pointer.
 */
export function legalEnds(context: SnapContext & { readonly start: Vec3 }, within: number): Vec3[] {
  const { start, plane, lockAxis } = context;
  const cursor = lockAxis
    ? context.cursor
    : projectToPlane(context.cursor, { normal: plane.normal, through: start });
  const reach = subtract(cursor, start);
  const found = new Map<string, { point: Vec3; gap: number }>();
  for (const { direction } of lockAxis ? bothWays(lockAxis) : waysInPlane(context)) {
    const middle = dot(reach, direction.along);
    const first = Math.max(1, Math.ceil((middle - within) / direction.step));
    for (let n = first; n * direction.step <= middle + within; n++) {
      const point = walk(start, direction, n);
      const gap = distance(point, cursor);
      if (gap <= within) {
        found.set(point.map((x) => x.toFixed(3)).join(' '), { point, gap });
      }
    }
  }
  return [...found.values()]
    .sort((a, b) => a.gap - b.gap)
    .slice(0, MOST_ENDS)
    .map(({ point }) => point);
}

interface Started extends SnapContext {
  readonly start: Vec3;
}

interface Candidate extends Snap {
  /** What the distance is taken from. */
  readonly target: Vec3;
}

/** A first point: an end point, a node, or whole numbers on the plane. */
function snapFirst(context: SnapContext): Snap {
  const { cursor, plane, tolerance } = context;
  let best: Snap | null = null;
  let bestCost = Infinity;
  for (const { at, reason } of nodesNear(context)) {
    const gap = distance(at, cursor);
    if (gap <= tolerance && gap * PULL[reason] < bestCost) {
      best = { point: at, reason, length: 0 };
      bestCost = gap * PULL[reason];
    }
  }
  return best ?? { point: wholeOnPlane(cursor, plane), reason: 'plane', length: 0 };
}

/** Whole numbers along the plane; its own coordinate stays. */
function wholeOnPlane(point: Vec3, plane: Plane): Vec3 {
  const [x, y, z] = point;
  // Adding 0 turns -0 into 0.
  return projectToPlane([Math.round(x) + 0, Math.round(y) + 0, Math.round(z) + 0], plane);
}

/** End points and nodes within reach of the pointer. */
function nodesNear(context: SnapContext): { at: Vec3; reason: 'endpoint' | 'node' }[] {
  const { cursor, lines, tolerance } = context;
  return lines.flatMap((line) => {
    const span = subtract(line.to, line.from);
    const size = length(span);
    const edges = Math.max(1, Math.round(size));
    // The one node of the line that is nearest to the pointer is the only one to look at.
    const share = size > 0 ? dot(subtract(cursor, line.from), span) / (size * size) : 0;
    const index = Math.min(edges, Math.max(0, Math.round(share * edges)));
    const isEnd = index === 0 || index === edges;
    const at = index === 0 ? line.from : isEnd ? line.to : lerp(line.from, line.to, index / edges);
    return distance(at, cursor) <= tolerance
      ? [{ at, reason: isEnd ? ('endpoint' as const) : ('node' as const) }]
      : [];
  });
}

/** Ends at what is drawn already, as far as a line to there is legal. */
function nodeEnds(context: Started): Candidate[] {
  const { start, cursor, lockAxis } = context;
  return nodesNear(context).flatMap(({ at, reason }) => {
    const span = subtract(at, start);
    const whole = wholeLength(span);
    const along = lockAxis === null || isAlong(span, lockAxis);
    return whole !== null && isPlanar(span) && along
      ? [{ point: at, reason, length: whole, target: cursor }]
      : [];
  });
}

function isAlong(span: Vec3, axis: AxisName): boolean {
  return span.every((value, k) => k === axisIndex(axis) || Math.abs(value) <= WHOLE);
}

interface Way {
  readonly reason: SnapReason;
  readonly direction: Direction;
}

function bothWays(axis: AxisName): Way[] {
  const along = unitVector(axis);
  return [along, scale(along, -1)].map((unit) => ({
    reason: 'axis',
    direction: { along: unit, step: 1, stepVector: unit },
  }));
}

function waysInPlane(context: Started): Way[] {
  const { plane } = context;
  const named = (reason: SnapReason, directions: readonly Direction[]): Way[] =>
    directions.map((direction) => ({ reason, direction }));
  return [
    ...named('axis', axisDirections(plane)),
    ...named('parallel', parallelDirections(context)),
    ...named('pythagorean', pythagoreanDirections(plane)),
    ...named('sixty', sixtyDirections(plane)),
  ];
}

/** The slanted directions of the lines drawn so far that lie in the plane, each once. */
function parallelDirections(context: Started): Direction[] {
  const k = axisIndex(context.plane.normal);
  const found = new Map<string, Vec3>();
  for (const line of context.lines) {
    const span = subtract(line.to, line.from);
    const size = length(span);
    const slanted = span.filter((value) => Math.abs(value) > WHOLE).length === 2;
    if (size >= 1 - WHOLE && slanted && Math.abs(span[k]) <= WHOLE) {
      const flat: [number, number, number] = [...span];
      flat[k] = 0;
      const along = scale(flat, 1 / length(flat));
      const key = along.map((value) => Math.round(Math.abs(value) * 1e4) * sameSign(along)).join();
      found.set(key, found.get(key) ?? along);
    }
  }
  return [...found.values()].flatMap((along) =>
    [along, scale(along, -1)].map((unit) => ({ along: unit, step: 1, stepVector: unit })),
  );
}

/** Tells the two slants of one steepness apart, whichever way the line was drawn. */
function sameSign(along: Vec3): number {
  const [first = 1, second = 1] = along.filter((value) => value !== 0);
  return Math.sign(first * second);
}

/** On each way the whole number of steps that ends nearest to the pointer. */
function wayEnds(context: Started, cursor: Vec3, ways: readonly Way[]): Candidate[] {
  const reach = subtract(cursor, context.start);
  return ways.flatMap(({ reason, direction }) => {
    const steps = Math.round(dot(reach, direction.along) / direction.step);
    if (steps < 1) {
      return [];
    }
    const point = walk(context.start, direction, steps);
    return [{ point, reason, length: steps * direction.step, target: cursor }];
  });
}

/** Where the pointer is less than half a module from the start: one module along the nearest axis. */
function firstAxisEnd(context: Started, ways: readonly Way[]): Snap {
  const reach = subtract(context.cursor, context.start);
  let best: Direction | null = null;
  for (const { reason, direction } of ways) {
    const isNearer = best === null || dot(reach, direction.along) > dot(reach, best.along);
    if (reason === 'axis' && isNearer) {
      best = direction;
    }
  }
  const point = best ? walk(context.start, best, 1) : context.start;
  return { point, reason: 'axis', length: 1 };
}
