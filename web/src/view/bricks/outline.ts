import type { Point2 } from './mesh-builder.ts';

/** A corner of an outline with the outward normals of the walls before and after it. */
export interface OutlineVertex {
  readonly point: Point2;
  readonly before: Point2;
  readonly after: Point2;
}

/** A closed outline with the figure on its left: outer ones run counter-clockwise, inner clockwise. */
export type Outline = readonly OutlineVertex[];

/** Straight bars between points; a point without a bar is a disc. */
export interface BarGraph {
  readonly points: readonly Point2[];
  /** Pairs of point indices. Bars meet at shared points only. */
  readonly bars: readonly (readonly [number, number])[];
}

const FULL_TURN = 2 * Math.PI;

/**
 * The outlines of all points within `radius` of the bars: round ends, round outer corners, sharp
 * inner corners. Found by walking along the right-hand side of every bar in both directions.
 * @param segments sides of a full circle.
 */
export function outlineBars(graph: BarGraph, radius: number, segments: number): Outline[] {
  const neighbours = sortedNeighbours(graph);
  const outlines: Outline[] = [];
  const walked = new Set<string>();
  neighbours.forEach((around, start) => {
    if (around.length === 0) {
      outlines.push(disc(pointAt(graph, start), radius, segments));
    }
    for (const next of around) {
      if (!walked.has(`${start}>${next}`)) {
        outlines.push(walk({ graph, neighbours, walked, radius, segments }, start, next));
      }
    }
  });
  return outlines;
}

/** Twice the signed area: positive for an outer outline. */
export function signedArea(outline: Outline): number {
  let sum = 0;
  outline.forEach((vertex, i) => {
    const next = outline[(i + 1) % outline.length] ?? vertex;
    sum += vertex.point[0] * next.point[1] - next.point[0] * vertex.point[1];
  });
  return sum;
}

interface Walk {
  readonly graph: BarGraph;
  readonly neighbours: readonly (readonly number[])[];
  readonly walked: Set<string>;
  readonly radius: number;
  readonly segments: number;
}

function pointAt(graph: BarGraph, index: number): Point2 {
  return graph.points[index] ?? [0, 0];
}

function bearing(graph: BarGraph, from: number, to: number): number {
  const a = pointAt(graph, from);
  const b = pointAt(graph, to);
  return Math.atan2(b[1] - a[1], b[0] - a[0]);
}

function sortedNeighbours(graph: BarGraph): number[][] {
  const around: number[][] = graph.points.map(() => []);
  for (const [a, b] of graph.bars) {
    around[a]?.push(b);
    around[b]?.push(a);
  }
  return around.map((list, from) =>
    [...new Set(list)].sort((p, q) => bearing(graph, from, p) - bearing(graph, from, q)),
  );
}

function disc(centre: Point2, radius: number, segments: number): Outline {
  return Array.from({ length: segments }, (_, i) =>
    rounded(centre, radius, (i / segments) * FULL_TURN),
  );
}

function rounded(centre: Point2, radius: number, angle: number): OutlineVertex {
  const normal: Point2 = [Math.cos(angle), Math.sin(angle)];
  return {
    point: [centre[0] + radius * normal[0], centre[1] + radius * normal[1]],
    before: normal,
    after: normal,
  };
}

function walk(context: Walk, start: number, next: number): Outline {
  const vertices: OutlineVertex[] = [];
  let from = start;
  let to = next;
  while (!context.walked.has(`${from}>${to}`)) {
    context.walked.add(`${from}>${to}`);
    const onward = nextAround(context, from, to);
    vertices.push(...corner(context, from, to, onward));
    from = to;
    to = onward;
  }
  return vertices;
}

/** The first neighbour of `at` counter-clockwise from the way back to `from`. */
function nextAround(context: Walk, from: number, at: number): number {
  const around = context.neighbours[at] ?? [];
  const back = around.indexOf(from);
  return around[(back + 1) % around.length] ?? from;
}

/** Vertices where the walk turns from from-at to at-onward. */
function corner(context: Walk, from: number, at: number, onward: number): OutlineVertex[] {
  const { graph, radius, segments } = context;
  const heading = bearing(graph, from, at);
  const sweep = sweepBetween(heading + Math.PI, bearing(graph, at, onward));
  const turn = sweep - Math.PI;
  const firstNormal = heading - Math.PI / 2;
  const centre = pointAt(graph, at);
  if (Math.abs(turn) < 1e-6) {
    return [];
  }
  if (turn > 0) {
    const steps = Math.max(1, Math.round((segments * turn) / FULL_TURN));
    return Array.from({ length: steps + 1 }, (_, i) =>
      rounded(centre, radius, firstNormal + (turn * i) / steps),
    );
  }
  const middle = firstNormal + turn / 2;
  const reach = radius / Math.cos(turn / 2);
  const normal = (angle: number): Point2 => [Math.cos(angle), Math.sin(angle)];
  return [
    {
      point: [centre[0] + reach * Math.cos(middle), centre[1] + reach * Math.sin(middle)],
      before: normal(firstNormal),
      after: normal(firstNormal + turn),
    },
  ];
}

/** Angle from `a` counter-clockwise to `b`, in (0, 2 pi]. */
function sweepBetween(a: number, b: number): number {
  const sweep = (((b - a) % FULL_TURN) + FULL_TURN) % FULL_TURN;
  return sweep < 1e-9 ? FULL_TURN : sweep;
}
