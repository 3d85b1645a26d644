import { add, normalize, scale, subtract } from '../geometry/vec.ts';
import { lineLength, type SketchDocument, type SketchLine } from '../model/sketch.ts';
import { removeLines, replaceLines } from './edits.ts';
import { paintLines } from './paint-lines.ts';

// Stretches of lines are taken out of the drawing: what a part alone was there for.

interface LineStretch {
  readonly line: number;
  readonly from: number;
  readonly to: number;
}

/** Whether anything is left of the drawing without these stretches. */
export function mayCut(sketch: SketchDocument, stretches: readonly LineStretch[]): boolean {
  const gone = stretches.filter(({ line, from, to }) => from <= 0 && to >= lengthOf(sketch, line));
  return new Set(gone.map(({ line }) => line)).size < sketch.lines.length;
}

/** The drawing without some stretches of its lines, one of a line at most. */
export function cutStretches(
  sketch: SketchDocument,
  stretches: readonly LineStretch[],
): SketchDocument {
  const whole = new Set<number>();
  const shorter = new Map<number, SketchLine>();
  const rests: { readonly line: SketchLine; readonly colour: number | undefined }[] = [];
  for (const stretch of stretches) {
    const { line } = stretch;
    const rest = restOf(sketch, stretch);
    if (!rest) {
      continue;
    }
    const { before, after } = rest;
    const stays = before ?? after;
    if (stays) {
      shorter.set(line, stays);
    } else {
      whole.add(line);
    }
    if (before && after) {
      rests.push({ line: after, colour: sketch.colours?.lines?.[line] });
    }
  }
  let next = replaceLines(sketch, shorter);
  for (const { line, colour } of rests) {
    const index = next.lines.length;
    next = { ...next, lines: [...next.lines, line] };
    next = colour === undefined ? next : paintLines(next, new Set([index]), colour);
  }
  return removeLines(next, whole);
}

/** What is left of a line on either side of a stretch; null where the stretch has none of its edges. */
function restOf(sketch: SketchDocument, { line, from, to }: LineStretch) {
  const old = sketch.lines[line];
  const length = lengthOf(sketch, line);
  if (!old || to <= 0 || from >= length) {
    return null;
  }
  return {
    before: from > 0 ? { ...old, to: nodeOf(old, from) } : null,
    after: to < length ? { ...old, from: nodeOf(old, to) } : null,
  };
}

function lengthOf(sketch: SketchDocument, line: number): number {
  const known = sketch.lines[line];
  return known ? Math.round(lineLength(known)) : 0;
}

function nodeOf(line: SketchLine, node: number) {
  return add(line.from, scale(normalize(subtract(line.to, line.from)), node));
}
