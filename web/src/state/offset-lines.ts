import { type AxisName, scale, type Vec3 } from '../geometry/vec.ts';
import type { SketchDocument } from '../model/sketch.ts';
import { type Copied, copyLines } from './copy-lines.ts';
import { type LineMap, mapLine, mapLines, mirrorAt, shift } from './edits.ts';

/** What is done to lines by numbers. */
export type Offset =
  | { readonly kind: 'move'; readonly by: Vec3 }
  | { readonly kind: 'copies'; readonly by: Vec3; readonly count: number }
  | { readonly kind: 'mirror'; readonly axis: AxisName; readonly at: number };

export const MAX_COPIES = 50;
/** Farther away nobody draws. */
export const MAX_OFFSET = 999;

/** Whether an offset changes anything: no move by nothing, no copy onto itself. */
export function isOffset(offset: Offset): boolean {
  switch (offset.kind) {
    case 'move':
      return isVector(offset.by);
    case 'copies':
      return isVector(offset.by) && Number.isInteger(offset.count) && offset.count >= 1;
    case 'mirror':
      return Number.isInteger(2 * offset.at) && Math.abs(offset.at) <= MAX_OFFSET;
  }
}

function isVector(by: Vec3): boolean {
  const legal = by.every((x) => Number.isInteger(x) && Math.abs(x) <= MAX_OFFSET);
  return legal && by.some((x) => x !== 0);
}

/** The sketch with lines moved, copied in a row or mirrored by numbers. */
export function offsetLines(
  sketch: SketchDocument,
  chosen: ReadonlySet<number>,
  offset: Offset,
): Copied {
  if (offset.kind === 'move') {
    return { sketch: mapLines(sketch, chosen, shift(offset.by)), added: [] };
  }
  return copyLines(sketch, chosen, mapsOf(offset));
}

/** Where the lines would lie. */
export function offsetImages(
  sketch: SketchDocument,
  chosen: ReadonlySet<number>,
  offset: Offset,
): (readonly [Vec3, Vec3])[] {
  const lines = sketch.lines.filter((_, i) => chosen.has(i));
  return mapsOf(offset).flatMap((map) =>
    lines.map((line): readonly [Vec3, Vec3] => {
      const image = mapLine(line, map);
      return [image.from, image.to];
    }),
  );
}

function mapsOf(offset: Offset): LineMap[] {
  switch (offset.kind) {
    case 'move':
      return [shift(offset.by)];
    case 'copies':
      return Array.from({ length: Math.min(MAX_COPIES, offset.count) }, (_, i) =>
        shift(scale(offset.by, i + 1)),
      );
    case 'mirror':
      return [mirrorAt(offset.axis, offset.at)];
  }
}
