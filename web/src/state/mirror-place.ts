import { type AxisName, axisIndex, type Vec3 } from '../geometry/vec.ts';
import { boundsOfPoints } from '../model/bounds.ts';
import { pointKey, type SketchDocument, type SketchLine, sketchNodes } from '../model/sketch.ts';

/**
 * Where a mirror across `axis` stands for some lines, as a person means it: where the lines hang on
 * the rest of the sketch, when all those places are on one such plane (a wing on its hull); else a
 * mirror plane that the sketch has; else the far side of the lines, so that both halves touch.
 */
export function mirrorPlace(
  sketch: SketchDocument,
  selected: ReadonlySet<number>,
  axis: AxisName,
): number {
  const k = axisIndex(axis);
  const seams = new Set(seamsOf(sketch, selected).map((point) => round(point[k])));
  const [seam] = seams;
  if (seam !== undefined && seams.size === 1) {
    return seam;
  }
  const held = sketch.symmetries?.find(
    (symmetry) =>
      symmetry.kind === 'reflection' &&
      symmetry.normal.every((value, i) => (i === k ? value !== 0 : value === 0)),
  );
  if (held?.kind === 'reflection') {
    return held.offset / held.normal[k];
  }
  return boundsOfPoints(endsOf(linesOf(sketch, selected)))?.max[k] ?? 0;
}

/** Nodes that selected and other lines share. */
function seamsOf(sketch: SketchDocument, selected: ReadonlySet<number>): Vec3[] {
  const rest = new Set(sketch.lines.keys());
  for (const index of selected) {
    rest.delete(index);
  }
  const others = new Set(sketchNodes(linesOf(sketch, rest)).map((node) => pointKey(node.at)));
  return sketchNodes(linesOf(sketch, selected))
    .map((node) => node.at)
    .filter((at) => others.has(pointKey(at)));
}

function linesOf(sketch: SketchDocument, indices: ReadonlySet<number>): SketchLine[] {
  return sketch.lines.filter((_, index) => indices.has(index));
}

function endsOf(lines: readonly SketchLine[]): Vec3[] {
  return lines.flatMap((line) => [line.from, line.to]);
}

function round(value: number): number {
  return Math.round(value * 500) / 500;
}
