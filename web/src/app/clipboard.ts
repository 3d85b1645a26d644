import type { SketchDocument, SketchLine } from '../model/sketch.ts';
import { addLines, lineKey, mapLine, shift } from '../state/edits.ts';

/** How far a pasted copy is moved when it would lie on lines that are there. */
const STEP = 2;
const MAX_TRIES = 50;

/** The selected lines of a sketch. */
export function selectedLines(
  sketch: SketchDocument,
  selection: ReadonlySet<number>,
): SketchLine[] {
  return sketch.lines.filter((_, i) => selection.has(i));
}

/**
 * The sketch with copies of `lines`, moved along x and y until none of them lies on an old line.
 * @returns the sketch, and the indices of the copies.
 */
export function pasteLines(
  sketch: SketchDocument,
  lines: readonly SketchLine[],
): { sketch: SketchDocument; added: number[] } {
  const taken = new Set(sketch.lines.map(lineKey));
  let copies = [...lines];
  for (let i = 0; i < MAX_TRIES && copies.some((line) => taken.has(lineKey(line))); i++) {
    copies = copies.map((line) => mapLine(line, shift([STEP, STEP, 0])));
  }
  const next = addLines(sketch, copies);
  const added = next.lines.map((_, i) => i).slice(sketch.lines.length);
  return { sketch: next, added };
}
