import { type Drive, SHAFT_ENDS, type Shaft, shaftsFault } from '../model/shafts.ts';
import { type SketchDocument, versionOf } from '../model/sketch.ts';

/** Shafts and drives as a link holds them: lists of numbers, or 0 where there are none. */
export function encodeShafts({ shafts, drives }: SketchDocument): unknown {
  return shafts
    ? [
        shafts.map(rowOf),
        (drives ?? []).map(({ from, to, ratio, tolerance }) =>
          tolerance === undefined ? [from, to, ratio] : [from, to, ratio, tolerance],
        ),
      ]
    : 0;
}

/** Six coordinates; where something sits at an end, also what sits at either: 0 is nothing. */
function rowOf({ from, to, atFrom, atTo }: Shaft): number[] {
  const code = (end: Shaft['atTo']) => (end ? SHAFT_ENDS.indexOf(end) + 1 : 0);
  return [...from, ...to, ...(atFrom || atTo ? [code(atFrom), code(atTo)] : [])];
}

/** A row that says more than it can is no shaft. */
function shaftOf(row: readonly unknown[]): Record<string, unknown> {
  const [atFrom, atTo] = row.slice(6).map((code) => (code === 0 ? undefined : endOf(code)));
  return {
    from: row.slice(0, 3),
    to: row.length === 6 || row.length === 8 ? row.slice(3, 6) : row.slice(3),
    ...(atFrom === undefined ? {} : { atFrom }),
    ...(atTo === undefined ? {} : { atTo }),
  };
}

function endOf(code: unknown): unknown {
  return typeof code === 'number' ? (SHAFT_ENDS[code - 1] ?? code) : code;
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
  const shafts = rows.map(shaftOf);
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
