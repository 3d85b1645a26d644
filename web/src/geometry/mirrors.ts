import { dot, type Segment, type Vec3 } from './vec.ts';

/** A plane {p : normal . p = offset}; the normal has whole-numbered components. */
export interface MirrorPlane {
  readonly normal: Vec3;
  readonly offset: number;
}

/** Across the axes, and across the diagonals between two of them. */
const NORMALS: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 1, 0],
  [1, -1, 0],
  [0, 1, 1],
  [0, 1, -1],
  [1, 0, 1],
  [1, 0, -1],
];

/** Points that round alike are one place, as in the core (kSamePoint). */
const PLACES_PER_MODULE = 500;

/**
 * The planes that mirror a set of lines onto itself, across axes first. Lines are compared by what they
 * cover, in unit edges: one line may mirror onto two in a row.
 * @param lines any number; the time grows with their total length.
 */
export function findMirrors(lines: readonly Segment[]): MirrorPlane[] {
  const edges = lines.flatMap(unitEdges);
  if (edges.length === 0) {
    return [];
  }
  const covered = new Set(edges.map(edgeKey));
  return NORMALS.flatMap((normal) => {
    const plane = { normal, offset: middleAlong(edges, normal) };
    const onto = edges.every((edge) =>
      covered.has(
        edgeKey({ from: mirrorPoint(edge.from, plane), to: mirrorPoint(edge.to, plane) }),
      ),
    );
    return onto ? [plane] : [];
  });
}

/** The mirror image of a point. */
export function mirrorPoint(point: Vec3, { normal, offset }: MirrorPlane): Vec3 {
  const step = (2 * (offset - dot(normal, point))) / dot(normal, normal);
  return [point[0] + step * normal[0], point[1] + step * normal[1], point[2] + step * normal[2]];
}

/** A symmetric set reaches equally far to both sides: no other offset is possible. */
function middleAlong(edges: readonly Segment[], normal: Vec3): number {
  let low = Infinity;
  let high = -Infinity;
  for (const { from, to } of edges) {
    const a = dot(normal, from);
    const b = dot(normal, to);
    low = Math.min(low, a, b);
    high = Math.max(high, a, b);
  }
  return Math.round(((low + high) / 2) * 1e6) / 1e6;
}

function unitEdges({ from, to }: Segment): Segment[] {
  const span = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  const count = Math.max(1, Math.round(span));
  const at = (i: number): Vec3 => [
    from[0] + ((to[0] - from[0]) * i) / count,
    from[1] + ((to[1] - from[1]) * i) / count,
    from[2] + ((to[2] - from[2]) * i) / count,
  ];
  return Array.from({ length: count }, (_, i) => ({ from: at(i), to: at(i + 1) }));
}

function edgeKey({ from, to }: Segment): string {
  const a = placeKey(from);
  const b = placeKey(to);
  return a < b ? `${a}|${b}` : `${b}|${a}`;
}

function placeKey(p: Vec3): string {
  const [x, y, z] = p.map((value) => Math.round(value * PLACES_PER_MODULE) + 0);
  return `${x},${y},${z}`;
}
