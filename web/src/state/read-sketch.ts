import { bad, good, type Outcome } from '../base/outcome.ts';
import type { AxisName, Vec3 } from '../geometry/vec.ts';
import { type Keep, keepFault } from '../model/keep.ts';
import { type Drive, plainShaft, type Shaft, shaftsFault } from '../model/shafts.ts';
import {
  isRange,
  type KeepOutBox,
  lineLength,
  type SketchDocument,
  type SketchJoint,
  type SketchLine,
  type SketchSymmetry,
  versionOf,
} from '../model/sketch.ts';
import { coloursFault, type SketchColours, tidyColours } from '../model/sketch-colours.ts';
import { strictFault } from './strict-sketch.ts';

// What the page needs to trust a sketch before it draws it. The core's reader is the authority on the
// format; this one keeps the same limits (core/sketch/sketch_json.h) so that the page cannot be hurt.

export const MAX_SKETCH_BYTES = 8 * 2 ** 20;
export const MAX_LINES = 20000;
export const MAX_COORDINATE = 2000;
/** Bodies that share one joint. */
export const MAX_JOINT_BODIES = 16;
/** 0.95 is 0.05 off 1, though not in binary. */
const LENGTH_TOLERANCE = 0.05 + 1e-9;
const MAX_NAME = 200;
const MAX_DIRECTION = 1e6;
const MAX_OFFSET = 1e10;
const MOST = { joints: 1000, symmetries: 500, keepOut: 10000 };

/** Thrown inside this file alone: the place and what would be right. */
class Refusal extends Error {}

/** Reads the text of a sketch file; on failure one sentence that names the place. */
export function readSketch(text: string): Outcome<SketchDocument> {
  if (text.length > MAX_SKETCH_BYTES) {
    return bad('the file is larger than 8 MB, which is the limit');
  }
  if (text.trim() === '') {
    return bad('the file is empty');
  }
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch (error) {
    const why = error instanceof Error ? error.message : 'unreadable';
    // It quotes the text, line ends and all; a refusal is one line.
    return bad(`this is not JSON: ${why.replace(/\s+/g, ' ')}`);
  }
  const read = readSketchValue(json);
  const fault = read.ok ? strictFault(json, read.value) : null;
  return fault === null ? read : bad(fault);
}

/** Reads a sketch that was parsed already, as one stored by an earlier visit. */
export function readSketchValue(json: unknown): Outcome<SketchDocument> {
  try {
    return good(readDocument(json));
  } catch (error) {
    if (error instanceof Refusal) {
      return bad(error.message);
    }
    throw error;
  }
}

/** The text of a sketch file. */
export function writeSketch(sketch: SketchDocument): string {
  const { lines, ...rest } = sketch;
  const head = JSON.stringify(rest).slice(0, -1);
  const rows = lines.map((line) => `    ${JSON.stringify(line)}`);
  return `${head},"lines":[\n${rows.join(',\n')}\n]}\n`;
}

function readDocument(json: unknown): SketchDocument {
  const root = record(json, 'sketch');
  if (root['format'] !== 'technic-sketch') {
    throw new Refusal('format: should be "technic-sketch"');
  }
  if (root['version'] !== 1 && root['version'] !== 2) {
    throw new Refusal('version: should be 1 or 2');
  }
  const lines = list(root['lines'], 'lines', MAX_LINES).map((line, i) =>
    readLine(line, `lines[${i}]`),
  );
  const optional = (key: keyof typeof MOST) =>
    root[key] === undefined ? [] : list(root[key], key, MOST[key]);
  const joints = optional('joints').map((value, i) =>
    readJoint(value, `joints[${i}]`, lines.length),
  );
  const symmetries = optional('symmetries').map((value, i) =>
    readSymmetry(value, `symmetries[${i}]`, lines.length),
  );
  const keepOut = optional('keepOut').map((value, i) => readBox(value, `keepOut[${i}]`));
  const colours = readColours(root, lines.length);
  const keep = readKeep(root, lines);
  const turning = readShafts(root);
  return {
    format: 'technic-sketch',
    version: versionOf({
      joints,
      ...turning,
      ...(colours ? { colours } : {}),
      ...(keep ? { keep } : {}),
    }),
    ...(typeof root['name'] === 'string' ? { name: root['name'].slice(0, MAX_NAME) } : {}),
    lines,
    ...(joints.length > 0 ? { joints } : {}),
    ...(symmetries.length > 0 ? { symmetries } : {}),
    ...(keepOut.length > 0 ? { keepOut } : {}),
    ...(root['ground'] === undefined || root['ground'] === null
      ? {}
      : { ground: coordinate(root['ground'], 'ground') }),
    ...turning,
    ...(keep ? { keep } : {}),
    ...(colours ? { colours } : {}),
  };
}

/** In version 1 nothing turns. */
function readShafts(root: Record<string, unknown>): Pick<SketchDocument, 'shafts' | 'drives'> {
  const { shafts, drives } = root;
  if (root['version'] === 1) {
    return {};
  }
  const fault = shaftsFault(shafts, drives);
  if (fault !== null) {
    throw new Refusal(fault);
  }
  // Other keys are not taken along: strict-sketch.ts refuses them in files.
  const axles = ((shafts ?? []) as readonly Shaft[]).map(plainShaft);
  const couplings = ((drives ?? []) as readonly Drive[]).map(({ from, to, ratio, tolerance }) => ({
    from,
    to,
    ratio,
    ...(tolerance === undefined ? {} : { tolerance }),
  }));
  return {
    ...(axles.length > 0 ? { shafts: axles } : {}),
    ...(couplings.length > 0 ? { drives: couplings } : {}),
  };
}

/** Version 1 keeps nothing. */
function readKeep(
  root: Record<string, unknown>,
  lines: readonly SketchLine[],
): readonly Keep[] | null {
  const { keep } = root;
  if (root['version'] === 1 || keep === undefined) {
    return null;
  }
  const fault = keepFault(
    keep,
    lines.map((line) => Math.round(lineLength(line))),
  );
  if (fault !== null) {
    throw new Refusal(fault);
  }
  return keep as readonly Keep[];
}

/** Version 1 has no colours; nothing else tells the two apart. */
function readColours(root: Record<string, unknown>, lineCount: number): SketchColours | null {
  const { colours } = root;
  if (root['version'] === 1 || colours === undefined) {
    return null;
  }
  const fault = coloursFault(colours, lineCount);
  if (fault !== null) {
    throw new Refusal(fault);
  }
  return tidyColours(colours as SketchColours);
}

function readLine(json: unknown, place: string): SketchLine {
  const value = record(json, place);
  const line: SketchLine = {
    from: point(value['from'], `${place}.from`),
    to: point(value['to'], `${place}.to`),
    ...(flag(value['exact'], `${place}.exact`) ? { exact: true } : {}),
    ...(value['holeAxis'] === undefined
      ? {}
      : { holeAxis: axisName(value['holeAxis'], `${place}.holeAxis`) }),
  };
  checkLine(line, place);
  return line;
}

function checkLine(line: SketchLine, place: string): void {
  const length = lineLength(line);
  const whole = Math.round(length);
  if (whole < 1) {
    throw new Refusal(`${place}: the ends are the same point; a line is at least 1 module long`);
  }
  if (Math.abs(length - whole) > LENGTH_TOLERANCE) {
    const low = Math.max(1, Math.floor(length));
    const twice = Math.round(2 * length);
    // Half modules: parts have their holes a module apart, so the drawing has to grow.
    const grown =
      Math.abs(2 * length - twice) <= LENGTH_TOLERANCE
        ? `; with the whole drawing twice as large it would be ${twice}`
        : '';
    throw new Refusal(
      `${place}: length ${trim(length)} is not a whole number of modules; nearest: ${low} or ${low + 1}${grown}`,
    );
  }
  const inPlane = [0, 1, 2].some(
    (k) => Math.abs((line.from[k] ?? 0) - (line.to[k] ?? 0)) <= LENGTH_TOLERANCE,
  );
  if (!inPlane) {
    throw new Refusal(
      `${place}: the line lies in no plane parallel to XY, YZ or ZX; make its ends equal in x, y or z`,
    );
  }
}

function readJoint(json: unknown, place: string, count: number): SketchJoint {
  const value = record(json, place);
  const joint: SketchJoint = {
    at: point(value['at'], `${place}.at`),
    axis: point(value['axis'], `${place}.axis`, MAX_DIRECTION),
    ...readRange(value, place),
  };
  if (value['between'] === undefined) {
    return joint;
  }
  const between = list(value['between'], `${place}.between`, MAX_JOINT_BODIES).map((group, i) =>
    list(group, `${place}.between[${i}]`, count).map((n, k) =>
      lineIndex(n, `${place}.between[${i}][${k}]`, count),
    ),
  );
  if (between.length < 2) {
    throw new Refusal(`${place}.between: should be two or more lists of line numbers`);
  }
  return { ...joint, between };
}

function readRange(value: Record<string, unknown>, place: string): Pick<SketchJoint, 'range'> {
  const { kind, range } = value;
  if (kind !== undefined && kind !== 'hinge') {
    throw new Refusal(`${place}.kind: should be "hinge"`);
  }
  if (range !== undefined && !isRange(range)) {
    throw new Refusal(`${place}.range: should be two angles in degrees, such as [-180, 180]`);
  }
  return range ? { range } : {};
}

function readSymmetry(json: unknown, place: string, count: number): SketchSymmetry {
  const value = record(json, place);
  const indices = (list_: unknown, where: string) =>
    list(list_, where, MAX_LINES).map((n, i) => lineIndex(n, `${where}[${i}]`, count));
  if (value['kind'] === 'translation') {
    const pairs = list(value['pairs'], `${place}.pairs`, MAX_LINES).map((pair, i) => {
      const [a, b, ...more] = indices(pair, `${place}.pairs[${i}]`);
      if (a === undefined || b === undefined || more.length > 0) {
        throw new Refusal(`${place}.pairs[${i}]: should be two line numbers`);
      }
      return [a, b] as const;
    });
    return {
      kind: 'translation',
      vector: point(value['vector'], `${place}.vector`, 2 * MAX_COORDINATE),
      pairs,
    };
  }
  if (value['kind'] !== 'reflection') {
    throw new Refusal(`${place}.kind: should be "reflection" or "translation"`);
  }
  return {
    kind: 'reflection',
    normal: point(value['normal'], `${place}.normal`, MAX_DIRECTION),
    offset: coordinate(value['offset'], `${place}.offset`, MAX_OFFSET),
    ...(value['lines'] === undefined ? {} : { lines: indices(value['lines'], `${place}.lines`) }),
  };
}

function readBox(json: unknown, place: string): KeepOutBox {
  const value = record(json, place);
  return { min: point(value['min'], `${place}.min`), max: point(value['max'], `${place}.max`) };
}

function record(json: unknown, place: string): Record<string, unknown> {
  if (typeof json !== 'object' || json === null || Array.isArray(json)) {
    throw new Refusal(`${place}: should be an object`);
  }
  return json as Record<string, unknown>;
}

function list(json: unknown, place: string, limit: number): unknown[] {
  if (!Array.isArray(json)) {
    throw new Refusal(`${place}: should be a list`);
  }
  if (json.length > limit) {
    throw new Refusal(`${place}: ${json.length} entries, at most ${limit} are allowed`);
  }
  return json;
}

function point(json: unknown, place: string, limit = MAX_COORDINATE): Vec3 {
  const values = list(json, place, 3).map((value, i) => coordinate(value, `${place}[${i}]`, limit));
  const [x, y, z] = values;
  if (x === undefined || y === undefined || z === undefined) {
    throw new Refusal(`${place}: should be three numbers`);
  }
  return [x, y, z];
}

function coordinate(json: unknown, place: string, limit = MAX_COORDINATE): number {
  if (typeof json !== 'number' || !Number.isFinite(json)) {
    throw new Refusal(`${place}: should be a number`);
  }
  if (Math.abs(json) > limit) {
    throw new Refusal(`${place}: ${json} is beyond the limit of ${limit} modules`);
  }
  return json;
}

function lineIndex(json: unknown, place: string, count: number): number {
  if (typeof json !== 'number' || !Number.isInteger(json) || json < 0 || json >= count) {
    throw new Refusal(`${place}: should be a line number from 0 to ${count - 1}`);
  }
  return json;
}

function flag(json: unknown, place: string): boolean {
  if (json !== undefined && typeof json !== 'boolean') {
    throw new Refusal(`${place}: should be true or false`);
  }
  return json === true;
}

function axisName(json: unknown, place: string): AxisName {
  if (json !== 'x' && json !== 'y' && json !== 'z') {
    throw new Refusal(`${place}: should be "x", "y" or "z"`);
  }
  return json;
}

function trim(value: number): string {
  return String(Math.round(value * 1000) / 1000);
}
