import { lerp, type Vec3 } from '../geometry/vec.ts';
import type { SketchDocument, SketchLine, SketchNode } from '../model/sketch.ts';
import type { LinePick, NodePick, Pick, Projected, ScreenPoint } from './view-types.ts';

/** Where a point of space is on screen. */
export type Projector = (point: Vec3) => Projected;

/** How near the pointer must be, CSS pixels; a finger reaches further. */
const REACH = { line: 8, node: 12, coarse: 2 } as const;

/** What of a sketch lies at a place on screen. */
export function pickSketch(
  at: ScreenPoint,
  drawn: { readonly sketch: SketchDocument | null; readonly nodes: readonly SketchNode[] },
  project: Projector,
  pointer: 'fine' | 'coarse',
): Pick {
  const times = pointer === 'coarse' ? REACH.coarse : 1;
  return {
    line: pickLine(at, drawn.sketch?.lines ?? [], project, REACH.line * times),
    node: pickNode(at, drawn.nodes, project, REACH.node * times),
  };
}

/** The line nearest to a place on screen within `reach` pixels, or null. */
export function pickLine(
  pointer: ScreenPoint,
  lines: readonly SketchLine[],
  project: Projector,
  reach: number,
): LinePick | null {
  let best: LinePick | null = null;
  lines.forEach((line, index) => {
    const a = project(line.from);
    const b = project(line.to);
    if (!a.visible || !b.visible) {
      return;
    }
    const t = nearestParameter(pointer, a, b);
    const distance = Math.hypot(
      a.x + (b.x - a.x) * t - pointer.x,
      a.y + (b.y - a.y) * t - pointer.y,
    );
    if (distance <= reach && (!best || distance < best.distance)) {
      best = { index, point: lerp(line.from, line.to, t), distance };
    }
  });
  return best;
}

/**
 * The node nearest to a place on screen within `reach` pixels, or null. Ends and junctions win over
 * inner nodes that are hardly nearer.
 */
export function pickNode(
  pointer: ScreenPoint,
  nodes: readonly SketchNode[],
  project: Projector,
  reach: number,
): NodePick | null {
  let best: NodePick | null = null;
  let bestRank = Infinity;
  for (const node of nodes) {
    const place = project(node.at);
    const distance = Math.hypot(place.x - pointer.x, place.y - pointer.y);
    const rank = distance + (node.kind === 'inner' ? INNER_HANDICAP : 0);
    if (place.visible && distance <= reach && rank < bestRank) {
      bestRank = rank;
      best = { at: node.at, kind: node.kind, lines: node.lines, distance };
    }
  }
  return best;
}

/** Pixels by which an inner node has to be nearer than an end. */
const INNER_HANDICAP = 3;

/** Parameter (0 to 1) of the point of a-b nearest to p, on screen. */
export function nearestParameter(p: ScreenPoint, a: ScreenPoint, b: ScreenPoint): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  const size = dx * dx + dy * dy;
  if (size === 0) {
    return 0;
  }
  return Math.min(1, Math.max(0, ((p.x - a.x) * dx + (p.y - a.y) * dy) / size));
}
