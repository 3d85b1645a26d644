import { isLegalLine } from '../geometry/legal-line.ts';
import { add, cross, length, subtract, type Vec3 } from '../geometry/vec.ts';
import {
  pointKey,
  type SketchDocument,
  type SketchJoint,
  type SketchLine,
} from '../model/sketch.ts';
import { mapLines, shift } from './edits.ts';
import { passesNode } from './follow-lines.ts';

/** A drawing after some of its points were pulled, with what hangs on them. */
export interface Stretched {
  readonly sketch: SketchDocument;
  /** Lines that are longer, shorter or slanted now. */
  readonly changed: readonly number[];
  /** Lines that have gone along as they are. */
  readonly carried: readonly number[];
}

/**
 * Moves points, and whatever must go along so that all lines keep whole lengths and stay joined: a line with one end
 * that moves becomes longer or shorter where that is legal, else its other end goes along too; what stands on a line goes
 * with it. So a corner of a box pulled sideways takes a whole side with it. A slanted pull goes along one axis after the
 * other where that takes fewer lines along.
 * @param by whole modules.
 */
export function stretch(sketch: SketchDocument, points: readonly Vec3[], by: Vec3): Stretched {
  const atOnce = compared(sketch, pull(sketch, points, by));
  if (by.filter((x) => x !== 0).length < 2) {
    return atOnce;
  }
  let [turn, at]: [SketchDocument, readonly Vec3[]] = [sketch, points];
  for (const step of stepsOf(by)) {
    turn = pull(turn, at, step);
    at = at.map((p) => add(p, step));
  }
  const inTurn = compared(sketch, turn);
  return inTurn.carried.length < atOnce.carried.length ? inTurn : atOnce;
}

function stepsOf([x, y, z]: Vec3): Vec3[] {
  const steps: Vec3[] = [
    [x, 0, 0],
    [0, y, 0],
    [0, 0, z],
  ];
  return steps.filter((step) => step.some((d) => d !== 0));
}

function compared(before: SketchDocument, sketch: SketchDocument): Stretched {
  const changed: number[] = [];
  const carried: number[] = [];
  sketch.lines.forEach((line, i) => {
    const old = before.lines[i];
    if (old && !sameLine(line, old)) {
      const sameSpan =
        pointKey(subtract(line.to, line.from)) === pointKey(subtract(old.to, old.from));
      (sameSpan ? carried : changed).push(i);
    }
  });
  return { sketch, changed, carried };
}

/** All of it at once. */
function pull(sketch: SketchDocument, points: readonly Vec3[], by: Vec3): SketchDocument {
  const moving = new Set(points.map(pointKey));
  const contacts = contactsOf(sketch.lines);
  while (sketch.lines.some((line, i) => pullAlong(line, contacts[i] ?? [], moving, by))) {
    // Until nothing more goes along: each round takes a point at least.
  }
  const moved = (p: Vec3) => (moving.has(pointKey(p)) ? add(p, by) : p);
  const lines = sketch.lines.map((line) => ({
    ...line,
    from: moved(line.from),
    to: moved(line.to),
  }));
  const all = lines.every((_, i) => {
    const old = sketch.lines[i];
    return old && [old.from, old.to].every((p) => moving.has(pointKey(p)));
  });
  if (all) {
    return mapLines(sketch, new Set(lines.keys()), shift(by));
  }
  const { joints, ...rest } = sketch;
  const kept = joints?.flatMap((joint) => jointAfter(joint, { sketch, lines, moving, by })) ?? [];
  return { ...rest, lines, ...(kept.length > 0 ? { joints: kept } : {}) };
}

/** One line alone with one of its ends pulled, torn off from what it is joined to; moved whole where that is not legal. */
export function tearOff(
  sketch: SketchDocument,
  index: number,
  end: Vec3,
  by: Vec3,
): SketchDocument {
  const line = sketch.lines[index];
  if (!line) {
    return sketch;
  }
  const pulled = (p: Vec3) => (pointKey(p) === pointKey(end) ? add(p, by) : p);
  const [from, to] = [pulled(line.from), pulled(line.to)];
  if (!isLegalLine(from, to)) {
    return mapLines(sketch, new Set([index]), shift(by));
  }
  const lines = sketch.lines.map((each, i) => (i === index ? { ...line, from, to } : each));
  const { joints, ...rest } = sketch;
  const kept = joints?.filter((joint) =>
    linesOf(joint, sketch).every((i) => passesNode(lines[i], joint.at)),
  );
  return { ...rest, lines, ...(kept && kept.length > 0 ? { joints: kept } : {}) };
}

function sameLine(a: SketchLine | undefined, b: SketchLine | undefined): boolean {
  return (
    a !== undefined &&
    b !== undefined &&
    pointKey(a.from) === pointKey(b.from) &&
    pointKey(a.to) === pointKey(b.to)
  );
}

type Contacts = readonly (readonly Vec3[])[];

/** Asked for at each move of the pointer, for the same lines. */
const known = new WeakMap<readonly SketchLine[], Contacts>();

function contactsOf(lines: readonly SketchLine[]): Contacts {
  const contacts = known.get(lines) ?? findContacts(lines);
  known.set(lines, contacts);
  return contacts;
}

/** For each line, ends of others that stand on a node inside it. */
function findContacts(lines: readonly SketchLine[]): Contacts {
  const ends = new Map(lines.flatMap(({ from, to }) => [from, to]).map((p) => [pointKey(p), p]));
  return lines.map((line) =>
    [...ends.values()].filter(
      (p) =>
        pointKey(p) !== pointKey(line.from) &&
        pointKey(p) !== pointKey(line.to) &&
        passesNode(line, p),
    ),
  );
}

/** Takes what must go along with one line into `moving`. @returns whether that was anything. */
function pullAlong(
  line: SketchLine,
  contacts: readonly Vec3[],
  moving: Set<string>,
  by: Vec3,
): boolean {
  const before = moving.size;
  const moved = (p: Vec3) => (moving.has(pointKey(p)) ? add(p, by) : p);
  const after: SketchLine = { ...line, from: moved(line.from), to: moved(line.to) };
  const stays = sameLine(line, after);
  const holds = contacts.every((p) => passesNode(after, moved(p)));
  const legal = stays || (isLegalLine(after.from, after.to) && !leans(line, after));
  if (!legal || !holds) {
    for (const p of [line.from, line.to, ...contacts]) {
      moving.add(pointKey(p));
    }
  }
  return moving.size > before;
}

/** A slant changes only where the line was slanted before: a post that is pulled sideways goes along instead. */
function leans(before: SketchLine, after: SketchLine): boolean {
  const a = subtract(before.to, before.from);
  const b = subtract(after.to, after.from);
  const straight = a.filter((x) => Math.abs(x) > 1e-6).length === 1;
  return straight && length(cross(a, b)) > 1e-6 * length(a) * Math.max(1, length(b));
}

interface Pull {
  readonly sketch: SketchDocument;
  readonly lines: readonly SketchLine[];
  readonly moving: ReadonlySet<string>;
  readonly by: Vec3;
}

function linesOf(joint: SketchJoint, { lines }: SketchDocument): number[] {
  const named = joint.between?.flat() ?? [...lines.keys()];
  return named.filter((i) => passesNode(lines[i], joint.at));
}

/** Where the lines of a joint meet now: where they met, or along with what was pulled. */
function jointAfter(joint: SketchJoint, { sketch, lines, moving, by }: Pull): SketchJoint[] {
  const of = linesOf(joint, sketch);
  const along = add(joint.at, by);
  const places = moving.has(pointKey(joint.at)) ? [along, joint.at] : [joint.at, along];
  const at = places.find((place) => of.every((i) => passesNode(lines[i], place)));
  return at ? [{ ...joint, at }] : [];
}
