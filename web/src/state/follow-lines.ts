import { add, dot, normalize, samePoint, scale, subtract, type Vec3 } from '../geometry/vec.ts';
import {
  lineNodes,
  type SketchDocument,
  type SketchJoint,
  type SketchLine,
  type SketchSymmetry,
} from '../model/sketch.ts';
import { followKeep } from './keeps.ts';

// What is said about lines goes with them when they are moved.

interface Move {
  readonly before: SketchDocument;
  /** The lines after the move, by the same indices. */
  readonly lines: readonly SketchLine[];
  readonly moved: ReadonlySet<number>;
  readonly point: (p: Vec3) => Vec3;
}

/** The sketch after a move: its joints and symmetries go with their lines, or are gone with them. */
export function followLines(move: Move): SketchDocument {
  const { joints = [], symmetries = [], ...rest } = move.before;
  const kept = joints.flatMap((joint) => jointAfter(joint, move));
  const all = move.before.lines.every((_, index) => move.moved.has(index));
  const held = all ? symmetries.map((symmetry) => symmetryAfter(symmetry, move)) : symmetries;
  return followKeep(move.before.lines, {
    ...rest,
    lines: move.lines,
    ...(kept.length > 0 ? { joints: kept } : {}),
    ...(held.length > 0 ? { symmetries: held } : {}),
  });
}

/** Whether a place is a node of a line, its ends included. */
export function passesNode(line: SketchLine | undefined, at: Vec3): boolean {
  return line !== undefined && lineNodes(line).some((node) => samePoint(node, at, 1e-3));
}

/** The joint where its lines meet now; none when they meet no more. */
function jointAfter(joint: SketchJoint, { before, lines, moved, point }: Move): SketchJoint[] {
  const named = joint.between?.flat() ?? [...before.lines.keys()];
  const of = named.filter((index) => passesNode(before.lines[index], joint.at));
  const goes = of.length > 0 && of.every((index) => moved.has(index));
  const after = goes
    ? { ...joint, at: point(joint.at), axis: directionAfter(joint.axis, point) }
    : joint;
  return of.every((index) => passesNode(lines[index], after.at)) ? [after] : [];
}

function symmetryAfter(symmetry: SketchSymmetry, { point }: Move): SketchSymmetry {
  if (symmetry.kind === 'translation') {
    return { ...symmetry, vector: subtract(point(symmetry.vector), point([0, 0, 0])) };
  }
  const { normal, offset } = symmetry;
  const onPlane = scale(normal, offset / dot(normal, normal));
  const turned = directionAfter(normal, point);
  return { ...symmetry, normal: turned, offset: dot(turned, point(onPlane)) + 0 };
}

/** A direction under a map of points, of unit length; -0 becomes 0. */
function directionAfter(direction: Vec3, point: (p: Vec3) => Vec3): Vec3 {
  const mapped = normalize(subtract(point(direction), point([0, 0, 0])));
  return add(mapped, [0, 0, 0]);
}
