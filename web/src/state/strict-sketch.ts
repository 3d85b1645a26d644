import type { Vec3 } from '../geometry/vec.ts';
import { lineLength, type SketchDocument, type SketchJoint } from '../model/sketch.ts';
import { unknownKey } from './known-keys.ts';

// What a sketch file must keep to beyond what the page needs to draw it (read-sketch.ts): the core refuses
// all of this (tests/contract/odd-inputs.json). What this browser stored is not asked so much: a drawing
// that the page let somebody draw must open again.

const MAX_NAME_BYTES = 200;
const MAX_TOTAL_LENGTH = 100_000;
const MAX_JOINT_LINES = 20_000;
/** As the reader's: modules that are snapped away. */
const SNAPPED = 0.05 + 1e-9;

const ROOT = ['format', 'version', 'name', 'lines', 'joints', 'symmetries', 'keepOut', 'ground'];
const MEMBERS = {
  lines: ['from', 'to', 'exact', 'holeAxis'],
  joints: ['at', 'axis', 'between', 'kind', 'range'],
  keepOut: ['min', 'max'],
  shafts: ['from', 'to', 'atFrom', 'atTo'],
  drives: ['from', 'to', 'ratio', 'tolerance'],
} as const;
/** Keys that only version 2 has. */
const LATEST: ReadonlySet<string> = new Set(['kind', 'range']);
const SYMMETRIES: Readonly<Record<string, readonly string[]>> = {
  reflection: ['kind', 'normal', 'offset', 'lines'],
  translation: ['kind', 'vector', 'pairs'],
};

type Fields = Readonly<Record<string, unknown>>;

/** The first thing that is wrong with a file whose sketch could be read, or null. */
export function strictFault(json: unknown, sketch: SketchDocument): string | null {
  const root = json as Fields;
  const keys = root['version'] === 2 ? [...ROOT, 'shafts', 'drives', 'keep', 'colours'] : ROOT;
  return (
    unknownKey(root, keys) ??
    nameFault(root['name']) ??
    linesFault(sketch) ??
    membersFault(root) ??
    (root['ground'] === null ? 'ground: should be a number' : null) ??
    jointsFault(sketch.joints ?? []) ??
    symmetriesFault(sketch) ??
    boxesFault(sketch)
  );
}

function nameFault(name: unknown): string | null {
  if (name === undefined) {
    return null;
  }
  if (typeof name !== 'string') {
    return 'name: should be a text';
  }
  if (new TextEncoder().encode(name).length > MAX_NAME_BYTES) {
    return `name: longer than ${MAX_NAME_BYTES} bytes`;
  }
  return [...name].some(steers) ? 'name: holds a line break or another control character' : null;
}

/** What steers a terminal or turns the direction of writing (core/base/plain_text.cpp). */
function steers(letter: string): boolean {
  const c = letter.codePointAt(0) ?? 0;
  const within = (low: number, high: number) => c >= low && c <= high;
  const turns = within(0x200e, 0x200f) || within(0x2028, 0x202e) || within(0x2066, 0x2069);
  return c < 0x20 || within(0x7f, 0x9f) || turns;
}

function linesFault({ lines }: SketchDocument): string | null {
  if (lines.length === 0) {
    return 'lines: empty; a sketch has at least one line';
  }
  const total = lines.reduce((sum, line) => sum + Math.round(lineLength(line)), 0);
  if (total > MAX_TOTAL_LENGTH) {
    return `lines: together ${total} modules long; at most ${MAX_TOTAL_LENGTH} are read`;
  }
  const along = lines.findIndex(({ from, to, holeAxis }) => {
    const k = holeAxis === undefined ? -1 : 'xyz'.indexOf(holeAxis);
    return k >= 0 && Math.abs((from[k] ?? 0) - (to[k] ?? 0)) > SNAPPED;
  });
  return along < 0 ? null : `lines[${along}].holeAxis: should be perpendicular to the line`;
}

/** Keys of lines, joints, symmetries and boxes. */
function keysOf(
  member: keyof typeof MEMBERS | 'symmetries',
  value: Fields,
  version: unknown,
): readonly string[] {
  if (member === 'symmetries') {
    return SYMMETRIES[String(value['kind'])] ?? [];
  }
  const known = MEMBERS[member];
  return version === 2 ? known : known.filter((key) => !LATEST.has(key));
}

function membersFault(root: Fields): string | null {
  for (const key of ['lines', 'joints', 'symmetries', 'keepOut', 'shafts', 'drives'] as const) {
    for (const [i, value] of ((root[key] ?? []) as readonly Fields[]).entries()) {
      const fault = unknownKey(value, keysOf(key, value, root['version']));
      if (fault !== null) {
        return `${key}[${i}]: ${fault}`;
      }
    }
  }
  return null;
}

function jointsFault(joints: readonly SketchJoint[]): string | null {
  const named = joints.reduce((sum, { between = [] }) => sum + between.flat().length, 0);
  if (named > MAX_JOINT_LINES) {
    return `joints: the joints name more than ${MAX_JOINT_LINES} lines together`;
  }
  for (const [i, { axis, between }] of joints.entries()) {
    const place = `joints[${i}]`;
    const fault = directionFault(axis, `${place}.axis`) ?? groupsFault(between, place);
    if (fault !== null) {
      return fault;
    }
  }
  return null;
}

function groupsFault(between: SketchJoint['between'], place: string): string | null {
  if (between === undefined) {
    return null;
  }
  const groups = between.map((group) => numbersFault(group, `${place}.between`));
  return groups.find((fault) => fault !== null) ?? twice(between.flat(), `${place}.between`);
}

function symmetriesFault({ symmetries = [] }: SketchDocument): string | null {
  for (const [i, symmetry] of symmetries.entries()) {
    const place = `symmetries[${i}]`;
    const fault =
      symmetry.kind === 'reflection'
        ? (directionFault(symmetry.normal, `${place}.normal`) ??
          (symmetry.lines ? numbersFault(symmetry.lines, `${place}.lines`) : null))
        : shiftFault(symmetry, place);
    if (fault !== null) {
      return fault;
    }
  }
  return null;
}

function shiftFault(
  { vector, pairs }: { readonly vector: Vec3; readonly pairs: readonly (readonly number[])[] },
  place: string,
): string | null {
  if (vector.every((x) => x === 0)) {
    return `${place}.vector: a shift must not be zero`;
  }
  if (pairs.length === 0) {
    return `${place}.pairs: expected at least one pair of line numbers`;
  }
  const wrong = pairs.findIndex((pair) => new Set(pair).size !== 2);
  return wrong < 0 ? null : `${place}.pairs[${wrong}]: should be two line numbers`;
}

function boxesFault({ keepOut = [] }: SketchDocument): string | null {
  const wrong = keepOut.findIndex(({ min, max }) => min.some((low, k) => low > (max[k] ?? 0)));
  return wrong < 0 ? null : `keepOut[${wrong}]: min should be nowhere above max`;
}

function directionFault(direction: Vec3, place: string): string | null {
  return Math.hypot(...direction) < 1e-6
    ? `${place}: a direction must not be zero; expected for example [0, 0, 1]`
    : null;
}

function numbersFault(numbers: readonly number[] | undefined, place: string): string | null {
  return numbers && numbers.length > 0
    ? twice(numbers, place)
    : `${place}: expected at least one line number`;
}

function twice(numbers: readonly number[], place: string): string | null {
  const seen = new Set<number>();
  const again = numbers.find((n) => seen.has(n) || !seen.add(n));
  return again === undefined ? null : `${place}: line ${again} is named twice`;
}
