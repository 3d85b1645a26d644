import { type Drive, type Shaft, shaftsFault } from '../model/shafts.ts';
import { type SketchDocument, versionOf } from '../model/sketch.ts';

/** Shafts and drives as a link holds them: lists of numbers, or 0 where there are none. */
export function encodeShafts({ shafts, drives }: SketchDocument): unknown {
  return shafts
    ? [
        shafts.map(({ from, to }) => [...from, ...to]),
        (drives ?? []).map(({ from, to, ratio, tolerance }) =>
          tolerance === undefined ? [from, to, ratio] : [from, to, ratio, tolerance],
        ),
      ]
    : 0;
}

/** The sketch with what turns in it; null when that is none. */
export function decodeShafts(sketch: SketchDocument, value: unknown): SketchDocument | null {
  if (value === 0) {
    return sketch;
  }
  if (!Array.isArray(value) || value.length !== 2 || !value.every(isListOfLists)) {
    return null;
  }
  const [rows = [], couplings = []] = value as readonly (readonly unknown[][])[];
  const shafts = rows.map((row) => ({ from: row.slice(0, 3), to: row.slice(3) }));
  const drives = couplings.map(([from, to, ratio, tolerance]) => ({
    from,
    to,
    ratio,
    ...(tolerance === undefined ? {} : { tolerance }),
  }));
  if (shafts.length === 0 || shaftsFault(shafts, drives) !== null) {
    return null;
  }
  const next = {
    ...sketch,
    shafts: shafts as unknown as readonly Shaft[],
    ...(drives.length > 0 ? { drives: drives as unknown as readonly Drive[] } : {}),
  };
  return { ...next, version: versionOf(next) };
}

function isListOfLists(value: unknown): boolean {
  return Array.isArray(value) && value.every(Array.isArray);
}
