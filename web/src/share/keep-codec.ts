import { type Keep, keepFault } from '../model/keep.ts';
import { lineLength, type SketchDocument } from '../model/sketch.ts';

/** The sketch with what it keeps, 0 for nothing; null when that is none. */
export function decodeKeep(sketch: SketchDocument, value: unknown): SketchDocument | null {
  if (value === 0) {
    return sketch;
  }
  const lengths = sketch.lines.map((line) => Math.round(lineLength(line)));
  return keepFault(value, lengths) === null
    ? { ...sketch, version: 2, keep: value as readonly Keep[] }
    : null;
}
