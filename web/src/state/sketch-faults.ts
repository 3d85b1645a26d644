import type { Vec3 } from '../geometry/vec.ts';
import type { SketchDocument } from '../model/sketch.ts';
import type { SketchNote } from '../model/sketch-notes.ts';
import { addLines, lineKey, removeLines, replaceLines } from './edits.ts';

/** Something in a sketch that is most likely not meant, before any search. */
export type SketchFault =
  | SketchNote
  /** The same line twice. */
  | { readonly kind: 'twin'; readonly at: Vec3; readonly lines: readonly [number, number] };

/** Faults beyond this many say nothing new. */
const MAX_FAULTS = 50;

/** Where lines look joined and are not: whatever is built, this is said of it. */
const LOUD: ReadonlySet<SketchFault['kind']> = new Set(['twin', 'crossing', 'near']);

/** Whether the verdict names it; pieces have a verdict of their own, and what was rounded is only told. */
export function isLoud({ kind }: SketchFault): boolean {
  return LOUD.has(kind);
}

/** Lines that were drawn twice, in their order. What else there is to say, the core says. */
export function findTwins(sketch: SketchDocument): SketchFault[] {
  const first = new Map<string, number>();
  const twins = sketch.lines.flatMap((line, index): SketchFault[] => {
    const key = lineKey(line);
    const known = first.get(key);
    if (known === undefined) {
      first.set(key, index);
      return [];
    }
    return [{ kind: 'twin', at: line.from, lines: [known, index] }];
  });
  return twins.slice(0, MAX_FAULTS);
}

/** Whether a click can mend it. */
export function hasMend(fault: SketchFault): boolean {
  return fault.kind === 'twin' || fault.mend.length > 0;
}

/** The sketch with a fault mended. */
export function mendFault(sketch: SketchDocument, fault: SketchFault): SketchDocument {
  if (fault.kind === 'twin') {
    return removeLines(sketch, new Set([fault.lines[1]]));
  }
  const moved = new Map(
    fault.mend.flatMap(({ line, from, to }) => {
      const drawn = line === undefined ? undefined : sketch.lines[line];
      return line === undefined || !drawn ? [] : [[line, { ...drawn, from, to }] as const];
    }),
  );
  const added = fault.mend.filter(({ line }) => line === undefined);
  return addLines(
    replaceLines(sketch, moved),
    added.map(({ from, to }) => ({ from, to })),
  );
}
