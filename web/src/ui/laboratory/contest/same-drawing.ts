import { add, scale, subtract, type Vec3 } from '../../../geometry/vec.ts';
import { lineLength, type SketchDocument } from '../../../model/sketch.ts';

/**
 * Whether two sketches are the same drawing in the same place: every edge of a module of one is one of the other,
 * however their lines are split, ordered and turned.
 */
export function isSameDrawing(a: SketchDocument, b: SketchDocument): boolean {
  const [mine, theirs] = [edgesOf(a), edgesOf(b)];
  return mine.size === theirs.size && [...mine].every((edge) => theirs.has(edge));
}

function edgesOf({ lines }: SketchDocument): Set<string> {
  return new Set(
    lines.flatMap((line) => {
      const count = Math.max(1, Math.round(lineLength(line)));
      const step = scale(subtract(line.to, line.from), 1 / count);
      return Array.from({ length: count }, (_, i) => {
        const from = add(line.from, scale(step, i));
        return edgeText(from, add(from, step));
      });
    }),
  );
}

function edgeText(a: Vec3, b: Vec3): string {
  const [low = '', high = ''] = [pointText(a), pointText(b)].sort();
  return `${low} ${high}`;
}

function pointText(p: Vec3): string {
  return p.map((x) => (Math.round(x * 100) / 100 + 0).toFixed(2)).join();
}
