import { distance } from '../geometry/vec.ts';
import { type SketchDocument, versionOf } from '../model/sketch.ts';
import {
  type ColourPlan,
  type PaintedPart,
  type SketchColours,
  tidyColours,
} from '../model/sketch-colours.ts';

/** Modules within which a part is the one that was painted. */
const SAME_PLACE = 0.01;

// Edits of what a sketch says of colours.

/** The sketch with other colours, or none with null; of the version that they need. */
export function setColours(sketch: SketchDocument, colours: SketchColours | null): SketchDocument {
  const { colours: _dropped, ...rest } = sketch;
  const tidy = colours && tidyColours(colours);
  return tidy ? { ...rest, version: 2, colours: tidy } : { ...rest, version: versionOf(rest) };
}

/** Colours beams by a scheme; null is the usual one. One colour for all beams goes. */
export function setScheme(sketch: SketchDocument, scheme: ColourPlan | null): SketchDocument {
  const { scheme: _scheme, default: _all, ...rest } = sketch.colours ?? {};
  return setColours(sketch, scheme ? { ...rest, scheme } : rest);
}

/** Gives all beams one colour. */
export function setBeamColour(sketch: SketchDocument, code: number): SketchDocument {
  const { scheme: _scheme, ...rest } = sketch.colours ?? {};
  return setColours(sketch, { ...rest, default: code });
}

/** Gives lines a colour, or takes theirs away with null. */
export function paintLines(
  sketch: SketchDocument,
  indices: ReadonlySet<number>,
  code: number | null,
): SketchDocument {
  const kept = Object.entries(sketch.colours?.lines ?? {}).filter(
    ([line]) => !indices.has(Number(line)),
  );
  const painted = code === null ? [] : [...indices].map((line) => [String(line), code] as const);
  return setColours(sketch, {
    ...sketch.colours,
    lines: Object.fromEntries([...kept, ...painted]),
  });
}

/** Gives one part of the model a colour, or takes its own away with null. */
export function paintPart(
  sketch: SketchDocument,
  { part, at }: Pick<PaintedPart, 'part' | 'at'>,
  colour: number | null,
): SketchDocument {
  const others = (sketch.colours?.parts ?? []).filter(
    (painted) => painted.part !== part || distance(painted.at, at) > SAME_PLACE,
  );
  const own = colour === null ? [] : [{ part, at, colour }];
  return setColours(sketch, { ...sketch.colours, parts: [...others, ...own] });
}

/** What a sketch says of colours once its lines have other numbers; lines without one are gone. */
export function renumberColours(
  sketch: SketchDocument,
  renumbered: ReadonlyMap<number, number>,
): SketchDocument {
  const { colours } = sketch;
  if (!colours?.lines) {
    return sketch;
  }
  const lines = Object.entries(colours.lines).flatMap(([line, code]) => {
    const to = renumbered.get(Number(line));
    return to === undefined ? [] : [[String(to), code] as const];
  });
  return setColours(sketch, { ...colours, lines: Object.fromEntries(lines) });
}
