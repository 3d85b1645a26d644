import { axisOf } from '../geometry/legal-line.ts';
import { distance, type Vec3 } from '../geometry/vec.ts';
import {
  type Drive,
  MAX_RATIO,
  MAX_SHAFT_SLOTS,
  plainShaft,
  type Shaft,
  type ShaftEnd,
} from '../model/shafts.ts';
import { type SketchDocument, versionOf } from '../model/sketch.ts';

// Edits of what turns in a sketch (docs/shafts.md): nothing here touches a store.

/** Whether a shaft may lie between two points: on the lattice, parallel to an axis, no longer than an axle. */
export function isLegalShaft(from: Vec3, to: Vec3): boolean {
  return (
    [...from, ...to].every(Number.isInteger) &&
    axisOf(from, to) !== null &&
    distance(from, to) < MAX_SHAFT_SLOTS
  );
}

export function addShaft(sketch: SketchDocument, shaft: Shaft): SketchDocument {
  return { ...sketch, version: 2, shafts: [...(sketch.shafts ?? []), shaft] };
}

/** Puts something at the ends of the shaft drawn last, null for nothing; the sketch as it is where there is none. */
export function withEnds(
  sketch: SketchDocument,
  ends: { readonly atFrom?: ShaftEnd | null; readonly atTo?: ShaftEnd | null },
): SketchDocument {
  const shafts = sketch.shafts ?? [];
  const last = shafts.at(-1);
  if (!last) {
    return sketch;
  }
  const { atFrom = last.atFrom, atTo = last.atTo } = ends;
  const bare = { from: last.from, to: last.to };
  const changed = { ...bare, ...(atFrom ? { atFrom } : {}), ...(atTo ? { atTo } : {}) };
  return { ...sketch, shafts: [...shafts.slice(0, -1), plainShaft(changed)] };
}

/** The last two shafts, the one that drives first, with the drive between them if there is one; null: fewer than two. */
export function lastPair(sketch: SketchDocument): { from: number; to: number } | null {
  const count = sketch.shafts?.length ?? 0;
  return count < 2 ? null : { from: count - 2, to: count - 1 };
}

/** Whether a number is a ratio that can be asked for. */
export function isRatio(ratio: number): boolean {
  return ratio >= 1 / MAX_RATIO && ratio <= MAX_RATIO;
}

/** Couples two shafts; what coupled the same two before goes. */
export function couple(sketch: SketchDocument, drive: Drive): SketchDocument {
  const pair = new Set([drive.from, drive.to]);
  const others = (sketch.drives ?? []).filter(({ from, to }) => !(pair.has(from) && pair.has(to)));
  return { ...sketch, drives: [...others, drive] };
}

/** The sketch without shafts and drives. */
export function clearShafts(sketch: SketchDocument): SketchDocument {
  const { shafts: _, drives: __, ...rest } = sketch;
  return { ...rest, version: versionOf(rest) };
}
