import { WHOLE } from '../geometry/legal-line.ts';
import { normalize, samePoint, scale, type Vec3 } from '../geometry/vec.ts';
import { lineLength, lineVector, type SketchDocument, type SketchLine } from '../model/sketch.ts';
import { stretch } from './stretch.ts';

/** An end of a line: the one that moves when its length is changed. */
export type LineEnd = 'from' | 'to';

/** Longer ones nobody means. */
export const MAX_LENGTH = 999;

/** Why a line cannot be so long. */
export type LengthRefusal =
  /** It is no whole number of modules. */
  | { readonly why: 'whole' }
  /** Along its direction, points of whole modules are further apart. */
  | { readonly why: 'step'; readonly step: number }
  /** Something stands on it there. */
  | { readonly why: 'held' };

export type Lengthened =
  | { readonly ok: true; readonly sketch: SketchDocument }
  | { readonly ok: false; readonly refusal: LengthRefusal };

/** Of which number a length has to be a multiple, so that both ends of the line stay on whole modules. */
export function lengthStep(line: SketchLine): number {
  const span = lineVector(line);
  if (!span.every(isWhole)) {
    return 1;
  }
  const [x, y, z] = span.map((value) => Math.abs(Math.round(value)));
  const parts = divisor(divisor(x ?? 0, y ?? 0), z ?? 0);
  return Math.max(1, Math.round(lineLength(line) / Math.max(1, parts)));
}

/** The sketch with one line of another length: one of its ends goes along it, with what hangs on that. */
export function setLength(
  sketch: SketchDocument,
  index: number,
  wish: { readonly end: LineEnd; readonly length: number },
): Lengthened {
  const line = sketch.lines[index];
  const { end, length } = wish;
  if (!line || !Number.isInteger(length) || length < 1 || length > MAX_LENGTH) {
    return { ok: false, refusal: { why: 'whole' } };
  }
  const step = lengthStep(line);
  if (length % step !== 0) {
    return { ok: false, refusal: { why: 'step', step } };
  }
  const more = length - Math.round(lineLength(line));
  const along = scale(normalize(lineVector(line)), end === 'to' ? more : -more);
  const after = stretch(sketch, [line[end]], tidy(along)).sketch;
  const made = after.lines[index];
  return made && Math.abs(lineLength(made) - length) < WHOLE
    ? { ok: true, sketch: after }
    : { ok: false, refusal: { why: 'held' } };
}

/** The end that is most likely meant to move: the one on which less hangs. */
export function freerEnd(sketch: SketchDocument, index: number): LineEnd {
  const line = sketch.lines[index];
  if (!line) {
    return 'to';
  }
  const hanging = (at: Vec3) =>
    sketch.lines.filter(({ from, to }) => [from, to].some((p) => samePoint(p, at, WHOLE))).length;
  return hanging(line.from) < hanging(line.to) ? 'from' : 'to';
}

function isWhole(value: number): boolean {
  return Math.abs(value - Math.round(value)) <= WHOLE;
}

/** Whole numbers that rounding has missed by little. */
function tidy(by: Vec3): Vec3 {
  const near = (x: number) => (isWhole(x) ? Math.round(x) + 0 : x);
  return [near(by[0]), near(by[1]), near(by[2])];
}

function divisor(a: number, b: number): number {
  return b === 0 ? a : divisor(b, a % b);
}
