// Numbers of parts as strokes, one high: seven segments a sign, as on a pocket calculator.

type Point = readonly [number, number];
type Stroke = readonly [Point, Point];

const WIDE = 0.5;
const STEP = 0.75;

/** From the top clockwise, the middle last. */
const SEGMENTS: Readonly<Record<string, Stroke>> = {
  a: [
    [0, 1],
    [WIDE, 1],
  ],
  b: [
    [WIDE, 1],
    [WIDE, 0.5],
  ],
  c: [
    [WIDE, 0.5],
    [WIDE, 0],
  ],
  d: [
    [0, 0],
    [WIDE, 0],
  ],
  e: [
    [0, 0.5],
    [0, 0],
  ],
  f: [
    [0, 1],
    [0, 0.5],
  ],
  g: [
    [0, 0.5],
    [WIDE, 0.5],
  ],
};

const SIGNS: Readonly<Record<string, string>> = {
  0: 'abcdef',
  1: 'bc',
  2: 'abged',
  3: 'abgcd',
  4: 'fgbc',
  5: 'afgcd',
  6: 'afgedc',
  7: 'abc',
  8: 'abcdefg',
  9: 'abcdfg',
  a: 'abcefg',
  b: 'cdefg',
  c: 'deg',
  d: 'bcdeg',
  e: 'adefg',
  f: 'aefg',
  h: 'cefg',
  l: 'def',
  n: 'ceg',
  o: 'cdeg',
  p: 'abefg',
  r: 'eg',
  s: 'afgcd',
  t: 'defg',
  u: 'cde',
  y: 'bcdfg',
  '-': 'g',
};

const LONGEST = 12;

/** The strokes of a number, from x = 0 to `width`, y from 0 to 1. Signs that have no segments are left free. */
export function signLines(text: string): { readonly lines: Stroke[]; readonly width: number } {
  const signs = [...text.toLowerCase()].slice(0, LONGEST);
  const lines = signs.flatMap((sign, i) =>
    [...(SIGNS[sign] ?? '')].flatMap((name): Stroke[] => {
      const stroke = SEGMENTS[name];
      return stroke ? [[shift(stroke[0], i), shift(stroke[1], i)]] : [];
    }),
  );
  return { lines, width: Math.max(WIDE, STEP * (signs.length - 1) + WIDE) };
}

function shift([x, y]: Point, place: number): Point {
  return [x + STEP * place, y];
}
