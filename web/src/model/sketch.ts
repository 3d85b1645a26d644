import { type AxisName, distance, lerp, subtract, type Vec3 } from '../geometry/vec.ts';
import type { Keep } from './keep.ts';
import type { Drive, Shaft } from './shafts.ts';
import type { SketchColours } from './sketch-colours.ts';

/** One straight line of whole length, as the sketch format (DESIGN 3) writes it. */
export interface SketchLine {
  readonly from: Vec3;
  readonly to: Vec3;
  /** Beams must pass exactly through the line (layer 0). */
  readonly exact?: boolean;
  /** Hole axis fixed by the user. */
  readonly holeAxis?: AxisName;
}

/** A point with an axis about which two or more groups of lines must turn. */
export interface SketchJoint {
  readonly at: Vec3;
  readonly axis: Vec3;
  /** Groups of line indices that move as one; left out where just two lines meet. */
  readonly between?: readonly (readonly number[])[];
  /** Degrees from the drawn pose through which it must turn with nothing in the way. */
  readonly range?: readonly [number, number];
}

export type SketchSymmetry =
  | {
      readonly kind: 'reflection';
      /** The plane {p : normal . p = offset}. */
      readonly normal: Vec3;
      readonly offset: number;
      /** Line indices; left out means all. */
      readonly lines?: readonly number[];
    }
  | {
      readonly kind: 'translation';
      readonly vector: Vec3;
      /** Line and its image. */
      readonly pairs: readonly (readonly [number, number])[];
    };

/** An axis-aligned box in modules that no part may enter (cells by their centres, inclusive). */
export interface KeepOutBox {
  readonly min: Vec3;
  readonly max: Vec3;
}

/** A sketch file; version 2 where it says something of colours, of what joints must do, of what turns or is to stay. */
export interface SketchDocument {
  readonly format: 'technic-sketch';
  readonly version: 1 | 2;
  readonly name?: string;
  readonly lines: readonly SketchLine[];
  readonly joints?: readonly SketchJoint[];
  readonly symmetries?: readonly SketchSymmetry[];
  readonly keepOut?: readonly KeepOutBox[];
  /** No part may lie below this z. */
  readonly ground?: number;
  readonly shafts?: readonly Shaft[];
  /** Which of the shafts gears couple. */
  readonly drives?: readonly Drive[];
  /** What is to stay of the model, by line. */
  readonly keep?: readonly Keep[];
  readonly colours?: SketchColours;
}

/** The oldest version of the format that has all of a sketch. */
export function versionOf(
  sketch: Pick<SketchDocument, 'joints' | 'colours' | 'keep' | 'shafts'>,
): 1 | 2 {
  const { colours, keep, shafts, joints } = sketch;
  return colours || keep || shafts || joints?.some((joint) => joint.range) ? 2 : 1;
}

/** Whether a value from outside is a range that a joint can be asked for. */
export function isRange(value: unknown): value is readonly [number, number] {
  if (!Array.isArray(value) || value.length !== 2) {
    return false;
  }
  const [from, to]: unknown[] = value;
  return (
    typeof from === 'number' &&
    typeof to === 'number' &&
    from >= -180 &&
    from <= 0 &&
    to >= 0 &&
    to <= 180 &&
    from < to
  );
}

/** A sketch without lines. */
export function emptySketch(name = ''): SketchDocument {
  return { format: 'technic-sketch', version: 1, name, lines: [] };
}

/** Length of a line in modules, not rounded. */
export function lineLength(line: SketchLine): number {
  return distance(line.from, line.to);
}

/** The points at unit spacing on a line, both ends included: length + 1 of them. */
export function lineNodes(line: SketchLine): Vec3[] {
  const edges = Math.max(1, Math.round(lineLength(line)));
  return Array.from({ length: edges + 1 }, (_, i) => lerp(line.from, line.to, i / edges));
}

/** A key that is equal for points closer than about a thousandth of a module. */
export function pointKey(p: Vec3): string {
  const rounded = p.map((value) => Math.round(value * 500));
  // -0 and 0 are one place.
  return rounded.map((value) => (value === 0 ? 0 : value)).join(',');
}

/** How a node of the sketch is used; decides how it is drawn. */
export type NodeKind = 'inner' | 'end' | 'junction';

/** A node with what is there. */
export interface SketchNode {
  readonly at: Vec3;
  readonly kind: NodeKind;
  /** Indices of the lines through the node, ascending. */
  readonly lines: readonly number[];
}

/**
 * All nodes of a sketch, each place once, in the order in which the lines first reach it.
 * A node is a junction when two or more lines share it, an end when exactly one line ends there.
 */
export function sketchNodes(lines: readonly SketchLine[]): SketchNode[] {
  const found = new Map<string, { at: Vec3; lines: number[]; isEnd: boolean }>();
  lines.forEach((line, index) => {
    const nodes = lineNodes(line);
    nodes.forEach((at, i) => {
      const key = pointKey(at);
      const isEnd = i === 0 || i === nodes.length - 1;
      const known = found.get(key);
      if (!known) {
        found.set(key, { at, lines: [index], isEnd });
        return;
      }
      known.isEnd = known.isEnd || isEnd;
      if (!known.lines.includes(index)) {
        known.lines.push(index);
      }
    });
  });
  return [...found.values()].map(({ at, lines: through, isEnd }) => ({
    at,
    lines: through,
    kind: through.length > 1 ? 'junction' : isEnd ? 'end' : 'inner',
  }));
}

/** Direction of a line from its first to its last point, not normalised. */
export function lineVector(line: SketchLine): Vec3 {
  return subtract(line.to, line.from);
}
