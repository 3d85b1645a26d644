import {
  type BarredPart,
  type Keep,
  type KeptPart,
  overlaps,
  type Place,
  samePart,
} from '../model/keep.ts';
import { lineVector, type SketchDocument, type SketchLine, versionOf } from '../model/sketch.ts';

// Edits of what a sketch keeps of its model: nothing here touches a store.

/** The sketch with other keeps, or none; of the version that they need. */
export function setKeep(sketch: SketchDocument, keep: readonly Keep[]): SketchDocument {
  const { keep: _dropped, ...rest } = sketch;
  const said = keep.flatMap(tidyKeep).sort((a, b) => a.line - b.line);
  return said.length > 0
    ? { ...rest, version: 2, keep: said }
    : { ...rest, version: versionOf(rest) };
}

/** Without empty lists; nothing where none is left. */
function tidyKeep(keep: Keep): Keep[] {
  const { line, ...lists } = keep;
  const full = Object.entries(lists).filter(([, list]) => list.length > 0);
  return full.length > 0 ? [{ line, ...(Object.fromEntries(full) as Omit<Keep, 'line'>) }] : [];
}

export function keepOf(sketch: SketchDocument, line: number): Keep {
  return sketch.keep?.find((keep) => keep.line === line) ?? { line };
}

function withKeep(sketch: SketchDocument, keep: Keep): SketchDocument {
  const others = (sketch.keep ?? []).filter((other) => other.line !== keep.line);
  return setKeep(sketch, [...others, keep]);
}

export function isKept(sketch: SketchDocument, { line, part }: Place): boolean {
  return keepOf(sketch, line).parts?.some((kept) => samePart(kept, part)) ?? false;
}

/** Keeps a part where it lies; kept parts that it would meet on its layer are kept no more. */
export function keepPart(sketch: SketchDocument, place: Place): SketchDocument {
  const free = withoutMeeting(sketch, place);
  const keep = keepOf(free, place.line);
  const barred = (keep.barred ?? []).filter((bar) => !isBarredBy(bar, place.part));
  return withKeep(free, { ...keep, barred, parts: [...(keep.parts ?? []), place.part] });
}

/** Keeps a part no more. */
export function releasePart(sketch: SketchDocument, { line, part }: Place): SketchDocument {
  const keep = keepOf(sketch, line);
  const parts = (keep.parts ?? []).filter((kept) => !samePart(kept, part));
  return withKeep(sketch, { ...keep, parts });
}

/** Lets a part lie no more on the stretch where it lies. */
export function barPart(sketch: SketchDocument, place: Place): SketchDocument {
  const free = releasePart(sketch, place);
  const keep = keepOf(free, place.line);
  const { part, from, to } = place.part;
  const known = keep.barred?.some((bar) => isBarredBy(bar, place.part)) ?? false;
  return known
    ? free
    : withKeep(free, { ...keep, barred: [...(keep.barred ?? []), { part, from, to }] });
}

/** Puts a part in the place of another: it is kept, and the other is not. */
export function swapPart(sketch: SketchDocument, before: Place, after: Place): SketchDocument {
  return keepPart(releasePart(sketch, before), after);
}

/** On which layers the beams of a line may lie; null: any. */
export function setLayers(
  sketch: SketchDocument,
  line: number,
  layers: readonly number[] | null,
): SketchDocument {
  const keep = keepOf(sketch, line);
  const parts = (keep.parts ?? []).filter(({ layer }) => layers?.includes(layer) ?? true);
  return withKeep(sketch, { ...keep, parts, layers: layers ?? [] });
}

/** Lets beams of a line end at a node, or wherever they do. */
export function toggleSplit(sketch: SketchDocument, line: number, node: number): SketchDocument {
  const keep = keepOf(sketch, line);
  const splits = keep.splits ?? [];
  return withKeep(sketch, {
    ...keep,
    splits: splits.includes(node)
      ? splits.filter((other) => other !== node)
      : [...splits, node].sort((a, b) => a - b),
  });
}

/** Nothing is kept on a line any more: neither parts nor rules. */
export function freeLine(sketch: SketchDocument, line: number): SketchDocument {
  const others = (sketch.keep ?? []).filter((keep) => keep.line !== line);
  return setKeep(sketch, others);
}

/** What a sketch keeps once its lines have other numbers; parts on lines without one are gone. */
export function renumberKeep(
  sketch: SketchDocument,
  renumbered: ReadonlyMap<number, number>,
): SketchDocument {
  const keep = (sketch.keep ?? []).flatMap((one): Keep[] => {
    const line = renumbered.get(one.line);
    return line === undefined
      ? []
      : [
          {
            ...one,
            line,
            parts: (one.parts ?? []).flatMap((part) => renumberPart(part, renumbered)),
          },
        ];
  });
  return sketch.keep ? setKeep(sketch, keep) : sketch;
}

function renumberPart(part: KeptPart, renumbered: ReadonlyMap<number, number>): KeptPart[] {
  if (!part.with) {
    return [part];
  }
  const bars = part.with.flatMap((bar) => {
    const line = renumbered.get(bar.line);
    return line === undefined ? [] : [{ ...bar, line }];
  });
  return bars.length === part.with.length ? [{ ...part, with: bars }] : [];
}

/** Drops what was kept on lines that have another length or direction now. */
export function followKeep(before: readonly SketchLine[], sketch: SketchDocument): SketchDocument {
  if (!sketch.keep) {
    return sketch;
  }
  const changed = new Set<number>();
  before.forEach((line, i) => {
    const now = sketch.lines[i];
    const was = lineVector(line);
    if (!now || lineVector(now).some((x, k) => Math.abs(x - (was[k] ?? 0)) > 1e-6)) {
      changed.add(i);
    }
  });
  const keep = sketch.keep
    .filter(({ line }) => !changed.has(line))
    .map((one) => ({
      ...one,
      parts: (one.parts ?? []).filter(
        (part) => !(part.with ?? []).some(({ line }) => changed.has(line)),
      ),
    }));
  return changed.size > 0 ? setKeep(sketch, keep) : sketch;
}

function withoutMeeting(sketch: SketchDocument, { line, part }: Place): SketchDocument {
  const bars = [{ line, ...part }, ...(part.with ?? [])];
  const meets = (on: number, kept: KeptPart) =>
    [{ line: on, from: kept.from, to: kept.to }, ...(kept.with ?? [])].some((theirs) =>
      bars.some((bar) => bar.line === theirs.line && overlaps(bar, theirs)),
    );
  const keep = (sketch.keep ?? []).map((one) => ({
    ...one,
    parts: (one.parts ?? []).filter((kept) => kept.layer !== part.layer || !meets(one.line, kept)),
  }));
  return sketch.keep ? setKeep(sketch, keep) : sketch;
}

function isBarredBy(bar: BarredPart, part: KeptPart): boolean {
  return bar.part === part.part && bar.from === part.from && bar.to === part.to;
}
