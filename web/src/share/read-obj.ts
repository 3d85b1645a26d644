import { bad, good, type Outcome } from '../base/outcome.ts';
import { distance, type Vec3 } from '../geometry/vec.ts';
import { linesOf } from '../model/delimited.ts';
import type { SketchDocument, SketchLine } from '../model/sketch.ts';
import { isYUp, unitOf } from './obj-units.ts';

/** An .obj file of this many records is no sketch. */
const MAX_RECORDS = 200_000;
const MAX_LINES = 20_000;
/** Modules. */
const MAX_COORDINATE = 2000;
const SURFACES = ['f', 'curv2', 'surf'];
const RECORD = /^(v|vn|vt|l|o|g|s|mtllib|usemtl|p|cstype|deg)\s/i;

/** What is wrong with a line of the file. */
class Refusal extends Error {}

/** One record, without what continues it on further rows. */
interface ObjRecord {
  /** Row of its beginning, from 1. */
  readonly row: number;
  /** Its kind first, in lower case. */
  readonly fields: readonly string[];
}

/**
 * Reads the line segments of a Wavefront .obj file (records `v`, `l`, and curves of degree one) as modules, Z up. Where a
 * comment or the numbers say that they are in another unit, or that Y is up, they are turned into that.
 * @param note told what was taken otherwise than it stands there, one sentence each.
 * @returns the sketch, or one sentence that names the place. Lengths are judged by the sketch reader.
 */
export function readObj(
  text: string,
  name: string,
  note: (sentence: string) => void = () => undefined,
): Outcome<SketchDocument> {
  try {
    const rows = linesOf(text);
    if (rows.length > MAX_RECORDS) {
      throw new Refusal(`the file has ${rows.length} rows, at most ${MAX_RECORDS} are allowed`);
    }
    const drawn = readLines(recordsOf(rows));
    const comments = rows.filter((row) => row.trim().startsWith('#')).join('\n');
    const lines = inModules(drawn, comments, note);
    return lines.length > 0
      ? good({ format: 'technic-sketch', version: 1, name, lines })
      : bad('the file holds no line segments (records that begin with "l")');
  } catch (error) {
    if (error instanceof Refusal) {
      return bad(error.message);
    }
    throw error;
  }
}

/** Whether a text looks like an .obj file: its first record that says something is one of its own. */
export function looksLikeObj(text: string): boolean {
  const first = linesOf(text.slice(0, 65_536)).find(
    (row) => row.trim() !== '' && !row.trim().startsWith('#'),
  );
  return RECORD.test(first?.trim() ?? '');
}

/** A backslash at the end of a row continues it on the next. */
function recordsOf(rows: readonly string[]): ObjRecord[] {
  const records: ObjRecord[] = [];
  let begun = '';
  let start = 0;
  rows.forEach((row, i) => {
    start = begun === '' ? i + 1 : start;
    const bare = row.replace(/#.*$/, '').trimEnd();
    if (bare.endsWith('\\')) {
      begun += `${bare.slice(0, -1)} `;
      return;
    }
    const [kind = '', ...rest] = (begun + bare).trim().split(/\s+/);
    begun = '';
    if (kind !== '') {
      records.push({ row: start, fields: [kind.toLowerCase(), ...rest] });
    }
  });
  return records;
}

/** Lines may name vertices that come after them, so these are read first. */
function readLines(records: readonly ObjRecord[]): SketchLine[] {
  const vertices: Vec3[] = [];
  const before = new Map<ObjRecord, number>();
  for (const record of records) {
    if (record.fields[0] === 'v') {
      vertices.push(readVertex(record));
    }
    before.set(record, vertices.length);
  }
  const lines: SketchLine[] = [];
  const seen = new Set<string>();
  for (const { record, names } of chainsOf(records)) {
    const known = before.get(record) ?? 0;
    addLines(lines, seen, readChain(names, { vertices, known, row: record.row }));
  }
  return lines;
}

/** Each record that joins vertices, with their names. */
function chainsOf(
  records: readonly ObjRecord[],
): { record: ObjRecord; names: readonly string[] }[] {
  let degree = 1;
  return records.flatMap((record) => {
    const [kind = '', ...rest] = record.fields;
    switch (kind) {
      case 'deg':
        degree = Number(rest[0]);
        return [];
      case 'l':
        return [{ record, names: rest }];
      case 'curv':
        if (degree === 1) {
          // It names the range of its parameter before its vertices.
          return [{ record, names: rest.slice(2) }];
        }
        break;
      default:
        if (!SURFACES.includes(kind)) {
          return [];
        }
    }
    throw new Refusal(`line ${record.row}: a surface; only line segments (v and l) can be read`);
  });
}

function readVertex({ row, fields }: ObjRecord): Vec3 {
  const numbers = fields.slice(1, 4);
  if (numbers.some((field) => /^[-+]?\d+,\d+$/.test(field))) {
    throw new Refusal(`line ${row}: a decimal comma; write ${numbers[0]?.replace(',', '.')}`);
  }
  const [x = Number.NaN, y = Number.NaN, z = Number.NaN] = numbers.map(Number);
  if (![x, y, z].every(Number.isFinite)) {
    throw new Refusal(`line ${row}: "v" should have three numbers`);
  }
  return [x, y, z];
}

interface Vertices {
  readonly vertices: readonly Vec3[];
  /** How many stand before the line, from which negative numbers count back. */
  readonly known: number;
  readonly row: number;
}

function readChain(names: readonly string[], { vertices, known, row }: Vertices): Vec3[] {
  if (names.length < 2) {
    throw new Refusal(`line ${row}: "l" should name at least two vertices`);
  }
  return names.map((field) => {
    const number = Number.parseInt(field, 10);
    const vertex = vertices[number > 0 ? number - 1 : known + number];
    if (number === 0 || !vertex) {
      throw new Refusal(`line ${row}: there is no vertex ${field}`);
    }
    return vertex;
  });
}

function addLines(lines: SketchLine[], seen: Set<string>, chain: readonly Vec3[]): void {
  for (let i = 0; i + 1 < chain.length; i++) {
    const from = chain[i];
    const to = chain[i + 1];
    const key = [from, to].map(String).sort().join(' ');
    if (from && to && distance(from, to) > 1e-6 && !seen.has(key)) {
      seen.add(key);
      lines.push({ from, to });
    }
  }
  if (lines.length > MAX_LINES) {
    throw new Refusal(`more than ${MAX_LINES} lines, which is the limit`);
  }
}

/** The same lines in modules with Z up, each once. */
function inModules(
  drawn: readonly SketchLine[],
  comments: string,
  note: (sentence: string) => void,
): SketchLine[] {
  const unit = drawn.length > 0 ? unitOf(comments, drawn) : null;
  const turned = isYUp(comments, drawn);
  if (unit) {
    note(`its numbers were taken for ${unit.name}; a module is 8 mm`);
  }
  if (turned) {
    note('it was turned so that its Y is up');
  }
  const size = unit?.size ?? 1;
  const place = ([x, y, z]: Vec3): Vec3 => {
    const [a, b, c] = turned ? [x, -z, y] : [x, y, z];
    return [clean(a * size), clean(b * size), clean(c * size)];
  };
  const lines: SketchLine[] = [];
  const seen = new Set<string>();
  for (const { from, to } of drawn) {
    const chain = [place(from), place(to)];
    if (chain.flat().some((x) => Math.abs(x) > MAX_COORDINATE)) {
      throw new Refusal(`a vertex lies more than ${MAX_COORDINATE} modules from the origin`);
    }
    addLines(lines, seen, chain);
  }
  return lines;
}

/** Modelling programs write 2.9999998 for 3. */
function clean(value: number): number {
  const rounded = Math.round(value * 1e5) / 1e5;
  return rounded === 0 ? 0 : rounded;
}
