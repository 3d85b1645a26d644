import { isLegalLine } from './legal-line.ts';
import { distance, length, subtract, type Vec3 } from './vec.ts';

/** A line by its ends, modules. */
export interface Segment {
  readonly from: Vec3;
  readonly to: Vec3;
}

export interface NearestLegal {
  readonly lines: readonly Segment[];
  /** For each line, how far the end that moved more has moved, modules. */
  readonly moved: readonly number[];
}

/** Ends this close are meant to be one point, and an end this close to a node of another line to be there. */
const JOINED = 0.15;
/** A line that differs so little along an axis is meant to lie across it. */
const ACROSS = 0.2;
/** A drawing that would have to move further than this is another drawing. */
const MOST_MOVED = 0.75;
/** Whole places are taken where they cost no more than this beyond the nearest. */
const WORTH_WHOLE = 0.3;
const SWEEPS = 4000;
const CLOSED = 1e-7;
/** Other whole lengths that are tried where some contradict each other. */
const TRIES = 24;

interface Ends {
  readonly from: number;
  readonly to: number;
}

/** Points that lines share, each once, and what is asked of them. */
interface Net {
  readonly points: readonly Vec3[];
  readonly lines: readonly Ends[];
  /** For each line, the axes that it lies across. */
  readonly across: readonly (readonly number[])[];
  readonly lengths: readonly number[];
  /** Ends at nodes inside another line: the point, the line, and how far along it, 0 to 1. */
  readonly touches: readonly {
    readonly point: number;
    readonly line: number;
    readonly at: number;
  }[];
}

/**
 * The nearest drawing whose lines all have whole length and lie in a plane that can be built, with ends joined that
 * nearly touch. Found by moving points towards what is asked of them, over and over; where lengths contradict each other
 * (12, 12 and 17 about a right angle), the next whole ones are tried.
 * @returns null where none is near.
 */
export function nearestLegal(lines: readonly Segment[]): NearestLegal | null {
  const net = netOf(lines);
  if (net === null) {
    return null;
  }
  const whole = judged(
    lines,
    net,
    net.points.map((p) => p.map(Math.round) as unknown as Vec3),
  );
  const relaxed = relaxedWith(lines, net);
  if (whole && (!relaxed || most(whole) <= most(relaxed) + WORTH_WHOLE)) {
    return whole;
  }
  return relaxed;
}

function most({ moved }: NearestLegal): number {
  return Math.max(0, ...moved);
}

function relaxedWith(lines: readonly Segment[], net: Net): NearestLegal | null {
  let lengths = net.lengths;
  for (let tries = 0; tries < TRIES; tries++) {
    const points = relax({ ...net, lengths });
    const found = judged(lines, { ...net, lengths }, points);
    if (found) {
      return found;
    }
    // The line that is furthest from its length gives way, to the other side of what it measures.
    const off = net.lines.map(({ from, to }, i) => span(points, from, to) - (lengths[i] ?? 0));
    const worst = off.reduce((w, x, i) => (Math.abs(x) > Math.abs(off[w] ?? 0) ? i : w), 0);
    const step = (off[worst] ?? 0) < 0 ? -1 : 1;
    lengths = lengths.map((each, i) => (i === worst ? Math.max(1, each + step) : each));
  }
  return null;
}

function span(points: readonly Vec3[], from: number, to: number): number {
  return distance(points[from] ?? [0, 0, 0], points[to] ?? [0, 0, 0]);
}

/** The lines between moved points, if they are legal and none has moved far. */
function judged(lines: readonly Segment[], net: Net, points: readonly Vec3[]): NearestLegal | null {
  const placed = net.lines.map(
    ({ from, to }): Segment => ({
      from: tidy(points[from] ?? [0, 0, 0]),
      to: tidy(points[to] ?? [0, 0, 0]),
    }),
  );
  const moved = placed.map(({ from, to }, i) => {
    const old = lines[i];
    return old ? Math.max(distance(from, old.from), distance(to, old.to)) : 0;
  });
  const touching = net.touches.every(({ point, line, at }) => {
    const other = placed[line];
    const p = points[point];
    return other && p && distance(p, along(other.from, other.to, at)) < 1e-3;
  });
  const legal = placed.every(({ from, to }) => isLegalLine(from, to));
  return legal && touching && moved.every((by) => by <= MOST_MOVED)
    ? { lines: placed, moved }
    : null;
}

function along(from: Vec3, to: Vec3, at: number): Vec3 {
  return [0, 1, 2].map(
    (k) => (from[k] ?? 0) + ((to[k] ?? 0) - (from[k] ?? 0)) * at,
  ) as unknown as Vec3;
}

/** Without the dust of the sweeps: a coordinate that is nearly whole is whole. */
function tidy(point: Vec3): Vec3 {
  return point.map((x) => {
    const nearest = Math.round(x);
    const value = Math.abs(x - nearest) < 1e-4 ? nearest : Math.round(x * 1e6) / 1e6;
    return value === 0 ? 0 : value;
  }) as unknown as Vec3;
}

/** What the lines ask of their points; null where one lies in no plane, or becomes a point. */
function netOf(lines: readonly Segment[]): Net | null {
  const points: Vec3[] = [];
  const nameOf = (p: Vec3): number => {
    const known = points.findIndex((other) => distance(other, p) <= JOINED);
    return known >= 0 ? known : points.push(p) - 1;
  };
  const ends = lines.map(({ from, to }): Ends => ({ from: nameOf(from), to: nameOf(to) }));
  const spans = lines.map(({ from, to }) => subtract(to, from));
  const across = spans.map((d) => [0, 1, 2].filter((k) => Math.abs(d[k] ?? 0) <= ACROSS));
  if (ends.some(({ from, to }) => from === to) || across.some((axes) => axes.length === 0)) {
    return null;
  }
  const lengths = spans.map((d) => Math.max(1, Math.round(length(d))));
  return { points, lines: ends, across, lengths, touches: touchesOf(points, ends, lengths) };
}

/** Ends near nodes inside other lines. */
function touchesOf(
  points: readonly Vec3[],
  lines: readonly Ends[],
  lengths: readonly number[],
): Net['touches'] {
  return lines.flatMap(({ from, to }, line) => {
    const [a, b] = [points[from], points[to]];
    const n = lengths[line] ?? 1;
    return points.flatMap((p, point) => {
      if (!a || !b || point === from || point === to) {
        return [];
      }
      const node = Array.from({ length: n - 1 }, (_, i) => (i + 1) / n).find(
        (at) => distance(p, along(a, b, at)) <= JOINED,
      );
      return node === undefined ? [] : [{ point, line, at: node }];
    });
  });
}

/** Moves points towards what is asked of them, one thing after the other, until all hold or the sweeps are over. */
function relax(net: Net): Vec3[] {
  const x = net.points.map((p) => [...p] as [number, number, number]);
  for (let sweep = 0; sweep < SWEEPS; sweep++) {
    let worst = 0;
    net.lines.forEach(({ from, to }, i) => {
      const [a, b] = [x[from], x[to]];
      if (a && b) {
        worst = Math.max(worst, levelOut(a, b, net.across[i] ?? []));
        worst = Math.max(worst, stretch(a, b, net.lengths[i] ?? 1));
      }
    });
    for (const { point, line, at } of net.touches) {
      const ends = net.lines[line];
      const [p, a, b] = [x[point], x[ends?.from ?? -1], x[ends?.to ?? -1]];
      if (p && a && b) {
        worst = Math.max(worst, pull(p, a, b, at));
      }
    }
    if (worst < CLOSED) {
      break;
    }
  }
  return x;
}

type Movable = [number, number, number];

/** Both ends to their mean along the axes that a line lies across. @returns how far they were from it. */
function levelOut(a: Movable, b: Movable, axes: readonly number[]): number {
  let off = 0;
  for (const k of axes as readonly (0 | 1 | 2)[]) {
    off = Math.max(off, Math.abs(a[k] - b[k]));
    const mean = (a[k] + b[k]) / 2;
    a[k] = mean;
    b[k] = mean;
  }
  return off;
}

/** Both ends apart or together, along the line. @returns how far it was from its length. */
function stretch(a: Movable, b: Movable, wanted: number): number {
  const d = subtract(b, a);
  const now = length(d);
  const by = now > 1e-9 ? (wanted - now) / now / 2 : 0;
  for (const k of [0, 1, 2] as const) {
    a[k] -= d[k] * by;
    b[k] += d[k] * by;
  }
  return Math.abs(wanted - now);
}

/** A point and the place on a line that it belongs to, together. @returns how far apart they were. */
function pull(p: Movable, a: Movable, b: Movable, at: number): number {
  let off = 0;
  for (const k of [0, 1, 2] as const) {
    const by = p[k] - (a[k] + (b[k] - a[k]) * at);
    p[k] -= by / 2;
    a[k] += by / 2;
    b[k] += by / 2;
    off = Math.max(off, Math.abs(by));
  }
  return off;
}
