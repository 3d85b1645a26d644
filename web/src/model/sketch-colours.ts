import type { Vec3 } from '../geometry/vec.ts';
import { isPartNumber } from './keep.ts';

// What a sketch of version 2 says of colours (DESIGN 3); core/sketch/sketch_colours.h is the authority.

/** How beams are coloured where nothing else is said. */
export const COLOUR_SCHEMES = ['length', 'component', 'usual'] as const;
export type ColourPlan = (typeof COLOUR_SCHEMES)[number];

const COLOUR_KINDS = ['beam', 'bent', 'pin', 'axle', 'connector', 'bush', 'gear'];
const KEYS = ['scheme', 'default', 'kinds', 'lines', 'parts'];
const MOST_PARTS = 20000;
const MAX_COORDINATE = 2000;
const MAX_COLOUR = 511;
/** LDraw's stand-ins for "as the whole" and "as its edges". */
const NO_COLOURS = [16, 24];

/** The colour of the part with this number whose origin is here, modules. */
export interface PaintedPart {
  readonly part: string;
  readonly at: Vec3;
  readonly colour: number;
}

/** LDraw codes. A part's goes before that of its line, a line's goes before that of a kind, that before the default, that before the scheme. */
export interface SketchColours {
  readonly scheme?: ColourPlan;
  /** Of beams. */
  readonly default?: number;
  readonly kinds?: Readonly<Record<string, number>>;
  /** By the number of a line. */
  readonly lines?: Readonly<Record<string, number>>;
  readonly parts?: readonly PaintedPart[];
}

/** Colours in the order in which they are written, without what is empty; null where nothing is said. */
export function tidyColours(colours: SketchColours): SketchColours | null {
  const { scheme, default: all, kinds, lines, parts } = colours;
  const tidy: SketchColours = {
    ...(scheme === undefined ? {} : { scheme }),
    ...(all === undefined ? {} : { default: all }),
    ...(kinds && Object.keys(kinds).length > 0 ? { kinds } : {}),
    ...(lines && Object.keys(lines).length > 0 ? { lines } : {}),
    ...(parts && parts.length > 0 ? { parts } : {}),
  };
  return Object.keys(tidy).length > 0 ? tidy : null;
}

/** What is wrong with the member `colours` of a file: the place and what would be right; null: nothing. */
export function coloursFault(value: unknown, lineCount: number): string | null {
  if (!isRecord(value)) {
    return 'colours: should be an object';
  }
  const stray = Object.keys(value).find((key) => !KEYS.includes(key));
  if (stray !== undefined) {
    return `colours: ${stray.slice(0, 20)} is not known`;
  }
  const { scheme, default: all, kinds = {}, lines = {}, parts = [] } = value;
  if (scheme !== undefined && !COLOUR_SCHEMES.some((known) => known === scheme)) {
    return `colours.scheme: should be one of ${COLOUR_SCHEMES.join(', ')}`;
  }
  if (all !== undefined && !isColour(all)) {
    return `colours.default: should be an LDraw code from 0 to ${MAX_COLOUR}`;
  }
  return (
    codesFault(kinds, 'colours.kinds', (key) => COLOUR_KINDS.includes(key)) ??
    codesFault(lines, 'colours.lines', (key) => isLine(key, lineCount)) ??
    partsFault(parts)
  );
}

function partsFault(value: unknown): string | null {
  if (!Array.isArray(value) || value.length > MOST_PARTS) {
    return `colours.parts: should be a list of at most ${MOST_PARTS}`;
  }
  const wrong = value.findIndex((painted: unknown) => !isPainted(painted));
  return wrong < 0 ? null : `colours.parts[${wrong}]: should have part, at and colour`;
}

function isPainted(value: unknown): value is PaintedPart {
  if (!isRecord(value)) {
    return false;
  }
  const { part, at, colour, ...rest } = value;
  const point =
    Array.isArray(at) &&
    at.length === 3 &&
    at.every((x) => Number.isFinite(x) && Math.abs(Number(x)) <= MAX_COORDINATE);
  return isPartNumber(part) && point && isColour(colour) && Object.keys(rest).length === 0;
}

function codesFault(value: unknown, place: string, known: (key: string) => boolean): string | null {
  if (!isRecord(value)) {
    return `${place}: should be an object`;
  }
  for (const [key, code] of Object.entries(value)) {
    if (!known(key)) {
      return `${place}: ${key.slice(0, 20)} is not known`;
    }
    if (!isColour(code)) {
      return `${place}.${key}: should be an LDraw code from 0 to ${MAX_COLOUR}`;
    }
  }
  return null;
}

function isLine(key: string, count: number): boolean {
  const line = Number(key);
  return Number.isInteger(line) && line >= 0 && line < count && String(line) === key;
}

function isColour(value: unknown): value is number {
  return (
    typeof value === 'number' &&
    Number.isInteger(value) &&
    value >= 0 &&
    value <= MAX_COLOUR &&
    !NO_COLOURS.includes(value)
  );
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
