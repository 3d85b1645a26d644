import { distance, lerp, type Vec3 } from '../geometry/vec.ts';
import type { PlacedPart } from './model.ts';
import { lineNodes, pointKey, type SketchDocument } from './sketch.ts';

/** More pairs of parts and edges than this are not compared while somebody draws. */
const MOST_PAIRS = 400_000;

/**
 * The parts of a model that do not fit a changed sketch: those nearest to an edge of the old one that
 * is gone. Edges that have come take nothing away.
 * @returns indices of the parts; null when all must be taken for unfit.
 */
export function unfitParts(
  parts: readonly PlacedPart[],
  before: SketchDocument,
  now: SketchDocument,
): ReadonlySet<number> | null {
  const kept = new Set(edgesOf(now).map((edge) => edge.key));
  const edges = edgesOf(before);
  if (parts.length * edges.length > MOST_PAIRS) {
    return null;
  }
  const gone = edges.filter((edge) => !kept.has(edge.key));
  const there = edges.filter((edge) => kept.has(edge.key));
  if (gone.length === 0) {
    return new Set();
  }
  const unfit = parts.flatMap((part, index) =>
    nearest(part.position, gone) < nearest(part.position, there) ? [index] : [],
  );
  return new Set(unfit);
}

interface Edge {
  readonly key: string;
  readonly middle: Vec3;
}

function edgesOf(sketch: SketchDocument): Edge[] {
  return sketch.lines.flatMap((line) => {
    const nodes = lineNodes(line);
    return nodes.slice(1).map((to, i) => {
      const middle = lerp(nodes[i] ?? to, to, 0.5);
      return { key: pointKey(middle), middle };
    });
  });
}

function nearest(at: Vec3, edges: readonly Edge[]): number {
  return edges.reduce((least, edge) => Math.min(least, distance(at, edge.middle)), Infinity);
}
