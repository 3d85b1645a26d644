import { meetings } from '../geometry/meetings.ts';
import { distance, normalize, scale, type Vec3 } from '../geometry/vec.ts';
import { lineVector, type SketchDocument } from '../model/sketch.ts';
import { lineKey, mapLines, removeLines, shift } from './edits.ts';

/** Something in a sketch that no parts can make, before any search. */
export type SketchFault =
  /** Two lines cross where one of them has no node: no pin can join them. */
  | {
      readonly kind: 'crossing';
      readonly at: Vec3;
      readonly lines: readonly [number, number];
      /** Moves the second line so that they cross at nodes. */
      readonly move: Vec3;
    }
  /** The same line twice. */
  | { readonly kind: 'twin'; readonly at: Vec3; readonly lines: readonly [number, number] };

/** Faults beyond this many say nothing new. */
const MAX_FAULTS = 50;

/** What cannot be built, in the order of the lines. */
export function findFaults(sketch: SketchDocument): SketchFault[] {
  return [...twins(sketch), ...crossings(sketch)].slice(0, MAX_FAULTS);
}

/** The sketch with a fault mended. */
export function mendFault(sketch: SketchDocument, fault: SketchFault): SketchDocument {
  const second = new Set([fault.lines[1]]);
  return fault.kind === 'twin'
    ? removeLines(sketch, second)
    : mapLines(sketch, second, shift(fault.move));
}

function twins(sketch: SketchDocument): SketchFault[] {
  const first = new Map<string, number>();
  return sketch.lines.flatMap((line, index): SketchFault[] => {
    const key = lineKey(line);
    const known = first.get(key);
    if (known === undefined) {
      first.set(key, index);
      return [];
    }
    return [{ kind: 'twin', at: line.from, lines: [known, index] }];
  });
}

function crossings(sketch: SketchDocument): SketchFault[] {
  return meetings(sketch.lines).flatMap(({ at, lines, atNode }): SketchFault[] => {
    const [a, b] = lines;
    const first = a === undefined ? undefined : sketch.lines[a];
    const second = b === undefined ? undefined : sketch.lines[b];
    if (atNode || a === undefined || b === undefined || !first || !second) {
      return [];
    }
    // Along the first line to its nearest node, and along its own so that one of its nodes is there.
    const alongFirst = scale(normalize(lineVector(first)), toWhole(distance(first.from, at)));
    const alongSecond = scale(normalize(lineVector(second)), -toWhole(distance(second.from, at)));
    const move: Vec3 = [
      tidy(alongFirst[0] + alongSecond[0]),
      tidy(alongFirst[1] + alongSecond[1]),
      tidy(alongFirst[2] + alongSecond[2]),
    ];
    return [{ kind: 'crossing', at, lines: [a, b], move }];
  });
}

/** What brings a number to the nearest whole one. */
function toWhole(value: number): number {
  return Math.round(value) - value;
}

/** Without the dust of rounding. */
function tidy(value: number): number {
  return Math.round(value * 1e6) / 1e6 + 0;
}
