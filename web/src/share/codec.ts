import { bad, good, type Outcome } from '../base/outcome.ts';
import type { AxisName, Vec3 } from '../geometry/vec.ts';
import type {
  KeepOutBox,
  SketchDocument,
  SketchJoint,
  SketchLine,
  SketchSymmetry,
} from '../model/sketch.ts';
import { coloursFault, type SketchColours, tidyColours } from '../model/sketch-colours.ts';
import { decodeKeep } from './keep-codec.ts';
import { checksum, deflate, fromBase64Url, inflate, toBase64Url } from './packing.ts';
import { decodeRanges, encodeRanges } from './range-codec.ts';
import { decodeShafts, encodeShafts } from './shafts-codec.ts';

/** What a link carries: the sketch and everything that the result depends on. */
export interface SharedState {
  readonly sketch: SketchDocument;
  readonly preset: string;
  readonly seed: number;
  /** What was changed from the usual settings; links of version 1 have none. */
  readonly settings?: SharedSettings;
}

export interface SharedSettings {
  /** How long to search, as a multiple of what is usual. */
  readonly effort: number;
  /** Parts that the search must not use. */
  readonly off: readonly string[];
  /** How many there are of each part. */
  readonly owned: Readonly<Record<string, number>>;
  /** Single options, one `key=value` a line. */
  readonly advanced: string;
}

export const MAX_FRAGMENT = 60_000;
const MAX_LINES = 5000;
const MAX_COORDINATE = 2000;
const MAX_TEXT = 120;
const MAX_PARTS = 200;
const MAX_ADVANCED = 4000;
const AXES: readonly AxisName[] = ['x', 'y', 'z'];
const UNREADABLE = 'This link is damaged: a part of it is missing or changed.';

/** A link's text as written by one version of the page: never change one, add the next. */
interface Version {
  readonly encode: (state: SharedState) => unknown;
  readonly decode: (value: unknown) => SharedState | null;
}

const VERSIONS: Readonly<Record<string, Version>> = {
  '1': { encode: encodeV1, decode: decodeV1 },
  '2': { encode: encodeV2, decode: decodeV2 },
  '3': { encode: encodeV3, decode: decodeV3 },
  '4': { encode: encodeV4, decode: decodeV4 },
  '5': { encode: encodeV5, decode: decodeV5 },
  '6': { encode: encodeV6, decode: decodeV6 },
};

/** The oldest version that holds all of a state: its link is the shortest, and older pages read it. */
function versionFor(state: SharedState): string {
  const { colours, joints, keep, shafts } = state.sketch;
  if (shafts) {
    return '6';
  }
  if (keep || colours?.parts) {
    return '5';
  }
  return joints?.some((joint) => joint.range) ? '4' : colours ? '3' : '2';
}

/** The address fragment, without `#`, for a state; a failure when the sketch is too large for a link. */
export async function encodeShare(state: SharedState): Promise<Outcome<string>> {
  if (state.sketch.lines.length > MAX_LINES) {
    return bad(`A link holds at most ${MAX_LINES} lines. Send the sketch file instead.`);
  }
  const version = versionFor(state);
  const fragment = await packFragment(version, JSON.stringify(VERSIONS[version]?.encode(state)));
  return fragment.length > MAX_FRAGMENT
    ? bad('This sketch is too large for a link. Send the sketch file instead.')
    : good(fragment);
}

/** The fragment that holds a text as what one version says, whether that version would write it or not. */
export async function packFragment(version: string, text: string): Promise<string> {
  const packed = toBase64Url(await deflate(text));
  return `s${version}.${packed}.${checksum(packed)}`;
}

/** The state in an address fragment; null when the fragment is none of ours. */
export async function decodeShare(fragment: string): Promise<Outcome<SharedState> | null> {
  const match = /^s(\d+)\.([^.]*)(?:\.(.*))?$/.exec(fragment);
  if (!match) {
    return null;
  }
  const [, number = '', packed = '', sum = ''] = match;
  const version = VERSIONS[number];
  if (!version) {
    return bad(
      'This link was made by a newer version of this page. Reload the page and try again.',
    );
  }
  if (fragment.length > MAX_FRAGMENT || sum !== checksum(packed)) {
    return bad(UNREADABLE);
  }
  try {
    const state = version.decode(JSON.parse(await inflate(fromBase64Url(packed))));
    return state ? good(state) : bad(UNREADABLE);
  } catch {
    return bad(UNREADABLE);
  }
}

// Version 1: [name, seed, preset, lines, joints, keepOut, ground, symmetries]; a line is
// [x, y, z, x, y, z, bits] with bits 1 exact, 2/4/6 hole axis x/y/z.

function encodeV1(state: SharedState): unknown {
  const { sketch } = state;
  return [
    (sketch.name ?? '').slice(0, MAX_TEXT),
    state.seed,
    state.preset,
    sketch.lines.map((line) => [...line.from.map(round), ...line.to.map(round), bitsOf(line)]),
    (sketch.joints ?? []).map((joint) => [joint.at, joint.axis, joint.between ?? 0]),
    (sketch.keepOut ?? []).map((box) => [box.min, box.max]),
    sketch.ground ?? null,
    sketch.symmetries ?? [],
  ];
}

function decodeV1(value: unknown): SharedState | null {
  if (!Array.isArray(value) || value.length !== 8) {
    return null;
  }
  const [name, seed, preset, rows, joints, boxes, ground] = value as unknown[];
  const lines = mapAll(rows, MAX_LINES, decodeLine);
  const readJoints = mapAll(joints, MAX_LINES, (row) => decodeJoint(row, lines?.length ?? 0));
  const keepOut = mapAll(boxes, MAX_LINES, decodeBox);
  if (!lines || !readJoints || !keepOut) {
    return null;
  }
  const sketch: SketchDocument = {
    format: 'technic-sketch',
    version: 1,
    name: typeof name === 'string' ? name.slice(0, MAX_TEXT) : '',
    lines,
    ...(readJoints.length > 0 ? { joints: readJoints } : {}),
    ...(keepOut.length > 0 ? { keepOut } : {}),
    ...(isCoordinate(ground) ? { ground } : {}),
    ...decodeSymmetries(value[7], lines.length),
  };
  return {
    sketch,
    seed: typeof seed === 'number' && Number.isInteger(seed) && seed >= 0 ? seed % 2 ** 31 : 1,
    preset: typeof preset === 'string' ? preset.slice(0, MAX_TEXT) : 'simple',
  };
}

// Version 2: version 1 with settings behind it, [effort, off, owned, advanced] or 0, and with symmetries
// of both kinds: version 1 lost translations.

function encodeV2(state: SharedState): unknown {
  const { settings } = state;
  const plain =
    !settings ||
    (settings.effort === 1 &&
      settings.off.length === 0 &&
      settings.advanced === '' &&
      Object.keys(settings.owned).length === 0);
  const extra = plain ? 0 : [settings.effort, settings.off, settings.owned, settings.advanced];
  return [...(encodeV1(state) as unknown[]), extra];
}

function decodeV2(value: unknown): SharedState | null {
  if (!Array.isArray(value) || value.length !== 9) {
    return null;
  }
  const state = decodeV1(value.slice(0, 7).concat([[]]));
  const settings = decodeSettings(value[8]);
  const count = state?.sketch.lines.length ?? 0;
  const symmetries = mapAll(value[7], 64, (row) => decodeSymmetry(row, count));
  if (!state || !symmetries || settings === null) {
    return null;
  }
  const sketch = symmetries.length > 0 ? { ...state.sketch, symmetries } : state.sketch;
  return { ...state, sketch, ...(settings ? { settings } : {}) };
}

// Version 3: version 2 with colours behind it.

function encodeV3(state: SharedState): unknown {
  return [...(encodeV2(state) as unknown[]), state.sketch.colours ?? 0];
}

function decodeV3(value: unknown): SharedState | null {
  if (!Array.isArray(value) || value.length !== 10) {
    return null;
  }
  const state = decodeV2(value.slice(0, 9));
  const colours: unknown = value[9];
  if (!state || coloursFault(colours, state.sketch.lines.length) !== null) {
    return null;
  }
  const tidy = tidyColours(colours as SketchColours);
  return tidy ? { ...state, sketch: { ...state.sketch, version: 2, colours: tidy } } : state;
}

// Version 4: version 3 with the ranges of its joints behind it.

function encodeV4(state: SharedState): unknown {
  return [...(encodeV3(state) as unknown[]), encodeRanges(state.sketch)];
}

function decodeV4(value: unknown): SharedState | null {
  if (!Array.isArray(value) || value.length !== 11) {
    return null;
  }
  const state = value[9] === 0 ? decodeV2(value.slice(0, 9)) : decodeV3(value.slice(0, 10));
  const sketch = state && decodeRanges(state.sketch, value[10]);
  return state && sketch ? { ...state, sketch } : null;
}

// Version 5: version 4 with what is to stay of the model behind it, or 0; single parts have colours.

function encodeV5(state: SharedState): unknown {
  return [...(encodeV4(state) as unknown[]), state.sketch.keep ?? 0];
}

function decodeV5(value: unknown): SharedState | null {
  if (!Array.isArray(value) || value.length !== 12) {
    return null;
  }
  const state = decodeV4(value.slice(0, 11));
  const sketch = state && decodeKeep(state.sketch, value[11]);
  return state && sketch ? { ...state, sketch } : null;
}

// Version 6: version 5 with what turns behind it.

function encodeV6(state: SharedState): unknown {
  return [...(encodeV5(state) as unknown[]), encodeShafts(state.sketch)];
}

function decodeV6(value: unknown): SharedState | null {
  if (!Array.isArray(value) || value.length !== 13) {
    return null;
  }
  const state = decodeV5(value.slice(0, 12));
  const sketch = state && decodeShafts(state.sketch, value[12]);
  return state && sketch ? { ...state, sketch } : null;
}

/** @returns undefined for the usual settings, null for what is none. */
function decodeSettings(value: unknown): SharedSettings | null | undefined {
  if (value === 0) {
    return undefined;
  }
  if (!Array.isArray(value) || value.length !== 4) {
    return null;
  }
  const [effort, off, owned, advanced] = value as unknown[];
  const parts = mapAll(off, MAX_PARTS, (id) => (isPartNumber(id) ? id : null));
  const counts = decodeCounts(owned);
  const known = typeof effort === 'number' && effort >= 0.01 && effort <= 100;
  if (!known || !parts || !counts || typeof advanced !== 'string') {
    return null;
  }
  return { effort, off: parts, owned: counts, advanced: advanced.slice(0, MAX_ADVANCED) };
}

function decodeCounts(value: unknown): Record<string, number> | null {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    return null;
  }
  const rows = Object.entries(value);
  const good_ = rows.every(
    ([id, count]) => isPartNumber(id) && Number.isInteger(count) && count >= 0 && count < 1e6,
  );
  return good_ && rows.length <= MAX_PARTS ? Object.fromEntries(rows) : null;
}

function isPartNumber(value: unknown): value is string {
  return typeof value === 'string' && /^\w{1,20}$/.test(value);
}

function decodeSymmetry(row: unknown, count: number): SketchSymmetry | null {
  if (typeof row !== 'object' || row === null) {
    return null;
  }
  const { kind, vector, pairs } = row as Record<string, unknown>;
  if (kind !== 'translation') {
    return decodeReflection(row, count);
  }
  const shift = decodePoint(vector);
  const read = mapAll(pairs, MAX_LINES, (pair) => {
    const [a, b, ...more] = decodeIndices(pair, count) ?? [];
    return a === undefined || b === undefined || more.length > 0 ? null : ([a, b] as const);
  });
  return shift && read ? { kind, vector: shift, pairs: read } : null;
}

function decodeLine(row: unknown): SketchLine | null {
  if (!Array.isArray(row) || row.length !== 7) {
    return null;
  }
  const from = decodePoint(row.slice(0, 3));
  const to = decodePoint(row.slice(3, 6));
  const bits: unknown = row[6];
  if (!from || !to || typeof bits !== 'number' || !Number.isInteger(bits)) {
    return null;
  }
  const holeAxis = AXES[(bits >> 1) - 1];
  return { from, to, ...(bits & 1 ? { exact: true } : {}), ...(holeAxis ? { holeAxis } : {}) };
}

function decodeJoint(row: unknown, lineCount: number): SketchJoint | null {
  if (!Array.isArray(row)) {
    return null;
  }
  const at = decodePoint(row[0]);
  const axis = decodePoint(row[1]);
  if (!at || !axis) {
    return null;
  }
  const between = mapAll(row[2], 64, (group) => decodeIndices(group, lineCount));
  return between ? { at, axis, between } : { at, axis };
}

function decodeSymmetries(value: unknown, count: number): Pick<SketchDocument, 'symmetries'> {
  const symmetries = mapAll(value, 64, (row) => decodeReflection(row, count));
  return symmetries && symmetries.length > 0 ? { symmetries } : {};
}

function decodeReflection(row: unknown, count: number) {
  if (typeof row !== 'object' || row === null) {
    return null;
  }
  const { kind, normal, offset, lines } = row as Record<string, unknown>;
  const direction = decodePoint(normal);
  if (kind !== 'reflection' || !direction || !isCoordinate(offset)) {
    return null;
  }
  const chosen = decodeIndices(lines, count);
  return { kind, normal: direction, offset, ...(chosen ? { lines: chosen } : {}) } as const;
}

function decodeIndices(value: unknown, count: number): number[] | null {
  return mapAll(value, MAX_LINES, (n) =>
    typeof n === 'number' && Number.isInteger(n) && n >= 0 && n < count ? n : null,
  );
}

function decodeBox(row: unknown): KeepOutBox | null {
  const min = Array.isArray(row) ? decodePoint(row[0]) : null;
  const max = Array.isArray(row) ? decodePoint(row[1]) : null;
  return min && max ? { min, max } : null;
}

function decodePoint(value: unknown): Vec3 | null {
  if (!Array.isArray(value) || value.length !== 3 || !value.every(isCoordinate)) {
    return null;
  }
  const [x, y, z] = value;
  return x === undefined || y === undefined || z === undefined ? null : [x, y, z];
}

/** The images of all entries, or null when it is no list, is too long, or one has no image. */
function mapAll<T>(value: unknown, limit: number, read: (entry: unknown) => T | null): T[] | null {
  if (!Array.isArray(value) || value.length > limit) {
    return null;
  }
  const result: T[] = [];
  for (const entry of value) {
    const read_ = read(entry);
    if (read_ === null) {
      return null;
    }
    result.push(read_);
  }
  return result;
}

function isCoordinate(value: unknown): value is number {
  return typeof value === 'number' && Number.isFinite(value) && Math.abs(value) <= MAX_COORDINATE;
}

function bitsOf(line: SketchLine): number {
  const axis = line.holeAxis ? AXES.indexOf(line.holeAxis) + 1 : 0;
  return (line.exact ? 1 : 0) + 2 * axis;
}

/** Six decimals keep 60-degree points well within the reader's tolerance. */
function round(value: number): number {
  return Math.round(value * 1e6) / 1e6;
}
