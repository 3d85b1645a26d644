// What a sketch of version 2 says of colours (DESIGN 3); core/sketch/sketch_colours.h is the authority.

/** How beams are coloured where nothing else is said. */
export const COLOUR_SCHEMES = ['length', 'component', 'usual'] as const;
export type ColourPlan = (typeof COLOUR_SCHEMES)[number];

const COLOUR_KINDS = ['beam', 'bent', 'pin', 'axle', 'connector', 'bush', 'gear'];
const KEYS = ['scheme', 'default', 'kinds', 'lines'];
const MAX_COLOUR = 511;
/** LDraw's stand-ins for "as the whole" and "as its edges". */
const NO_COLOURS = [16, 24];

/** LDraw codes. A line's goes before that of a kind, that before the default, that before the scheme. */
export interface SketchColours {
  readonly scheme?: ColourPlan;
  /** Of beams. */
  readonly default?: number;
  readonly kinds?: Readonly<Record<string, number>>;
  /** By the number of a line. */
  readonly lines?: Readonly<Record<string, number>>;
}

/** Colours in the order in which they are written, without what is empty; null where nothing is said. */
export function tidyColours(colours: SketchColours): SketchColours | null {
  const { scheme, default: all, kinds, lines } = colours;
  const tidy: SketchColours = {
    ...(scheme === undefined ? {} : { scheme }),
    ...(all === undefined ? {} : { default: all }),
    ...(kinds && Object.keys(kinds).length > 0 ? { kinds } : {}),
    ...(lines && Object.keys(lines).length > 0 ? { lines } : {}),
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
  const { scheme, default: all, kinds = {}, lines = {} } = value;
  if (scheme !== undefined && !COLOUR_SCHEMES.some((known) => known === scheme)) {
    return `colours.scheme: should be one of ${COLOUR_SCHEMES.join(', ')}`;
  }
  if (all !== undefined && !isColour(all)) {
    return `colours.default: should be an LDraw code from 0 to ${MAX_COLOUR}`;
  }
  return (
    codesFault(kinds, 'colours.kinds', (key) => COLOUR_KINDS.includes(key)) ??
    codesFault(lines, 'colours.lines', (key) => isLine(key, lineCount))
  );
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
