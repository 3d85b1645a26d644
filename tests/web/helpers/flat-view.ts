import type { Vec3 } from '../../../web/src/geometry/vec.ts';
import { sketchNodes } from '../../../web/src/model/sketch.ts';
import type { SketchStore } from '../../../web/src/state/store.ts';
import type { PointerInput, ToolView } from '../../../web/src/tools/tool.ts';
import type { ScreenPoint } from '../../../web/src/view/view-types.ts';

const SCALE = 20;

/** Where a point is seen from straight above: 20 pixels a module, y upwards. */
export function seenFromAbove(p: Vec3): ScreenPoint {
  return { x: 400 + p[0] * SCALE, y: 300 - p[1] * SCALE };
}

/** A pointer over a point of the ground. */
export function pointerOver(p: Vec3, shift = false): PointerInput {
  return { ...seenFromAbove(p), shift, kind: 'mouse' };
}

/** A view from straight above, without perspective. */
export function flatView(store: SketchStore): ToolView {
  return {
    rayAt: (at) => ({
      origin: [(at.x - 400) / SCALE, (300 - at.y) / SCALE, 100],
      direction: [0, 0, -1],
    }),
    project: (p) => ({ ...seenFromAbove(p), visible: true }),
    pickAt: (at) => ({ node: nearestNode(store, at), line: nearestLine(store, at) }),
    viewDirection: () => [0, 0, -1],
    pixelsPerModule: () => SCALE,
  };
}

function nearestNode(store: SketchStore, at: ScreenPoint) {
  const nodes = sketchNodes(store.sketch.value.lines).map((node) => {
    const seen = seenFromAbove(node.at);
    return { ...node, distance: Math.hypot(seen.x - at.x, seen.y - at.y) };
  });
  return nodes.sort((a, b) => a.distance - b.distance)[0] ?? null;
}

function nearestLine(store: SketchStore, at: ScreenPoint) {
  const node = nearestNode(store, at);
  const index = node?.lines[0];
  return node && index !== undefined ? { index, point: node.at, distance: node.distance } : null;
}
