import { bad, good, type Outcome } from '../base/outcome.ts';
import { add, type Mat3, rotate, type Vec3 } from '../geometry/vec.ts';
import type { Catalogue } from '../model/catalogue.ts';
import { BRICK_COLOURS, FALLBACK_COLOUR_CODE, findColour } from '../model/colours.ts';
import { linesOf } from '../model/delimited.ts';
import { mirrorPlane } from '../model/mirror-plane.ts';
import { knownNumber } from '../model/part-synonyms.ts';

const LDU_PER_MODULE = 20;
const MAX_PARTS = 200_000;
/** Visits: submodels that refer to each other many times are few rows in the file. */
const MAX_ROWS = 400_000;
const MAX_DEPTH = 60;
const MAX_FILES = 20_000;
/** Rows that are followed, counted before any is: submodels multiply, with or without a part in them. */
const MAX_VISITS = 400_000;
/** The colour of what holds it, and that of its edges, which is no colour of a part. */
const INHERITED_COLOURS = [16, 24];
const NAMED_AT_MOST = 24;

/** A place in LDraw's own coordinates: position in LDU, rotation row by row. */
interface Place {
  readonly position: Vec3;
  readonly rotation: Mat3;
  readonly color: number;
}

interface Row extends Place {
  readonly file: string;
}

interface PartRow {
  readonly part: string;
  readonly color: number;
  readonly position: Vec3;
  readonly rotation: Mat3;
}

/** What is wrong with the file. */
class Refusal extends Error {}

/**
 * Reads an LDraw document: the parts that the catalogue knows, under any of their numbers.
 * @param note told what was left out or taken otherwise than it stands there, one sentence each.
 * @returns the text of a model file without a sketch, or one sentence that names the place.
 */
export function readMpd(
  text: string,
  catalogue: Catalogue,
  note: (sentence: string) => void = () => undefined,
): Outcome<string> {
  try {
    const files = readFiles(text, note);
    const main = files.keys().next().value;
    if (main === undefined) {
      return bad('the file holds no parts (lines that begin with "1")');
    }
    const parts: PartRow[] = [];
    const root: Place = { position: [0, 0, 0], rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], color: 7 };
    const reader = new Placer(files, catalogue, parts);
    if (countVisits(files, main, [], new Map()) > MAX_VISITS) {
      throw new Refusal(`submodels and parts are more than ${MAX_VISITS}, which is the limit`);
    }
    reader.place(main, root);
    const left = reader.leftOut();
    if (parts.length === 0) {
      return bad(left[0] ?? 'the file holds no parts (lines that begin with "1")');
    }
    left.forEach(note);
    const name = main.replace(/\.(ldr|mpd|dat)$/i, '');
    return good(modelText(name, parts));
  } catch (error) {
    if (error instanceof Refusal) {
      return bad(error.message);
    }
    throw error;
  }
}

/** Whether a text looks like an LDraw file: its first rows are comments, parts, lines or surfaces of one. */
export function looksLikeMpd(text: string): boolean {
  const rows = linesOf(text.slice(0, 4096))
    .map((row) => row.trim())
    // A sign that some programs write before a note.
    .filter((row) => row !== '' && !row.startsWith('//'));
  const first = rows[0] ?? '';
  return /^0(\s|$)/.test(first) || /^1(\s+[-+#.\w]+){13}\s+\S/.test(first);
}

/** Names are told apart without regard to case and to how much white space they hold. */
function keyOf(name: string): string {
  return name.trim().replace(/\s+/g, ' ').toLowerCase();
}

/** The files of a document in their order. Of two with one name the first counts, as everywhere in LDraw. */
function readFiles(text: string, note: (sentence: string) => void): Map<string, Row[]> {
  const files = new Map<string, Row[]>();
  for (const { key, rows } of sectionsOf(text)) {
    if (files.has(key)) {
      note(`${key} stands there more than once; the first counts`);
    } else {
      files.set(key, rows);
    }
    if (files.size > MAX_FILES) {
      throw new Refusal(`more than ${MAX_FILES} submodels, which is the limit`);
    }
  }
  return files;
}

interface Section {
  readonly key: string;
  readonly rows: Row[];
}

/** Rows before the first FILE are a file of their own; those after a NOFILE belong to none. */
function sectionsOf(text: string): Section[] {
  const leading: Section = { key: 'model.ldr', rows: [] };
  const sections: Section[] = [];
  let rows: Row[] | null = leading.rows;
  linesOf(text).forEach((line, i) => {
    const named = /^\s*0\s+FILE\s(.+)$/is.exec(line);
    if (named?.[1]) {
      rows = [];
      sections.push({ key: keyOf(named[1]), rows });
    } else if (/^\s*0\s+NOFILE\b/i.test(line)) {
      rows = null;
    } else if (rows && /^\s*1\s/.test(line)) {
      rows.push(readRow(line, i));
    }
  });
  return leading.rows.length > 0 ? [leading, ...sections] : sections;
}

function readRow(line: string, index: number): Row {
  const fields = line.trim().split(/\s+/);
  const numbers = [colourOf(fields[1] ?? ''), ...fields.slice(2, 14).map(Number)];
  const file = keyOf(fields.slice(14).join(' '));
  if (numbers.length < 13 || !numbers.every(Number.isFinite) || file === '') {
    throw new Refusal(`line ${index + 1}: a part needs a colour, twelve numbers and a file name`);
  }
  const at = (i: number) => numbers[i] ?? 0;
  return {
    color: at(0),
    position: [at(1), at(2), at(3)],
    rotation: [at(4), at(5), at(6), at(7), at(8), at(9), at(10), at(11), at(12)],
    file,
  };
}

/**
 * A colour's code. One that is written as red, green and blue becomes the nearest in which parts are sold, one that is
 * not known the usual one. NaN where it is none.
 */
function colourOf(field: string): number {
  const direct = /^(?:0x|#)[0-9a-f]?([0-9a-f]{6})$/i.exec(field)?.[1];
  if (direct) {
    return nearestColour(Number.parseInt(direct, 16));
  }
  const code = Number(field);
  return !Number.isFinite(code) || INHERITED_COLOURS.includes(code) || findColour(code)
    ? code
    : FALLBACK_COLOUR_CODE;
}

function nearestColour(hex: number): number {
  const away = (other: number) =>
    [16, 8, 0].reduce((sum, at) => sum + (((hex >> at) & 255) - ((other >> at) & 255)) ** 2, 0);
  return BRICK_COLOURS.reduce((best, each) => (away(each.hex) < away(best.hex) ? each : best)).code;
}

/**
 * How many rows are followed from a file down, each as often as it is come by.
 * @param path the files that hold this one.
 */
function countVisits(
  files: ReadonlyMap<string, readonly Row[]>,
  file: string,
  path: readonly string[],
  known: Map<string, number>,
): number {
  if (path.includes(file)) {
    throw new Refusal(`${file}: the submodel holds itself`);
  }
  if (path.length > MAX_DEPTH) {
    throw new Refusal(`${file}: submodels are nested more than ${MAX_DEPTH} deep`);
  }
  let count = known.get(file);
  if (count === undefined) {
    count = 0;
    for (const row of files.get(file) ?? []) {
      const inside = files.has(row.file);
      count += 1 + (inside ? countVisits(files, row.file, [...path, file], known) : 0);
    }
    known.set(file, count);
  }
  return count;
}

/** Follows submodels down to parts. */
class Placer {
  readonly #files: ReadonlyMap<string, readonly Row[]>;
  readonly #catalogue: Catalogue;
  readonly #numbers: ReadonlySet<string>;
  readonly #parts: PartRow[];
  readonly #unknown = new Map<string, number>();
  readonly #missing = new Set<string>();
  #rows = 0;

  constructor(files: ReadonlyMap<string, readonly Row[]>, catalogue: Catalogue, parts: PartRow[]) {
    this.#files = files;
    this.#catalogue = catalogue;
    this.#numbers = new Set(catalogue.parts.map(({ id }) => id));
    this.#parts = parts;
  }

  /** What could not be placed, one sentence each. */
  leftOut(): string[] {
    const rows = [...this.#unknown].slice(0, NAMED_AT_MOST).map(([id, n]) => `${id} (${n})`);
    const parts = `${rows.join(', ')}${this.#unknown.size > rows.length ? ', …' : ''}`;
    const [missing] = this.#missing;
    return [
      ...(rows.length > 0 ? [`parts that are not known here are left out: ${parts}`] : []),
      ...(missing === undefined ? [] : [`what stands in another file is left out: ${missing}`]),
    ];
  }

  place(file: string, at: Place): void {
    for (const row of this.#files.get(file) ?? []) {
      this.#rows += 1;
      if (this.#rows > MAX_ROWS) {
        throw new Refusal(
          `more than ${MAX_ROWS} rows with all submodels in place, which is the limit`,
        );
      }
      const color = INHERITED_COLOURS.includes(row.color) ? at.color : row.color;
      const place = { ...compose(at, row), color };
      if (this.#files.has(row.file)) {
        this.place(row.file, place);
      } else {
        this.#add(row.file, place);
      }
    }
  }

  #add(file: string, place: Place): void {
    const part = knownNumber(file, this.#numbers);
    if (part === null) {
      if (/\.(ldr|mpd)$/.test(file)) {
        this.#missing.add(file.slice(0, 60));
      } else {
        const plain = file
          .replace(/^.*[\\/]/, '')
          .replace(/\.dat$/, '')
          .slice(0, 40);
        this.#unknown.set(plain, (this.#unknown.get(plain) ?? 0) + 1);
      }
      return;
    }
    if (this.#parts.length >= MAX_PARTS) {
      throw new Refusal(`more than ${MAX_PARTS} parts, which is the limit`);
    }
    this.#parts.push({
      part,
      color: place.color,
      ...this.#proper(part, toModules(place.position), toOurs(place.rotation)),
    });
  }

  /** A part that is its own mirror image may be placed as one: it is the same as turned. */
  #proper(part: string, position: Vec3, rotation: Mat3): Pick<PartRow, 'position' | 'rotation'> {
    const known = determinant(rotation) < 0 ? this.#catalogue.find(part) : undefined;
    const plane = known ? mirrorPlane(known) : null;
    if (!plane) {
      return { position, rotation };
    }
    const { axis, at } = plane;
    const shift: Vec3 = [0, 1, 2].map((k) => (k === axis ? 2 * at : 0)) as unknown as Vec3;
    const turned = rotation.map((x, i) => neat(i % 3 === axis ? -x : x)) as unknown as Mat3;
    const moved = add(position, rotate(rotation, shift));
    return { position: moved.map(neat) as unknown as Vec3, rotation: turned };
  }
}

function compose(outer: Place, inner: Row): Omit<Place, 'color'> {
  const m = outer.rotation;
  const n = inner.rotation;
  const p = inner.position;
  const o = outer.position;
  const row = (i: 0 | 3 | 6, j: 0 | 1 | 2): number =>
    (m[i] ?? 0) * (n[j] ?? 0) +
    (m[(i + 1) as 1 | 4 | 7] ?? 0) * (n[(j + 3) as 3 | 4 | 5] ?? 0) +
    (m[(i + 2) as 2 | 5 | 8] ?? 0) * (n[(j + 6) as 6 | 7 | 8] ?? 0);
  return {
    position: [
      o[0] + m[0] * p[0] + m[1] * p[1] + m[2] * p[2],
      o[1] + m[3] * p[0] + m[4] * p[1] + m[5] * p[2],
      o[2] + m[6] * p[0] + m[7] * p[1] + m[8] * p[2],
    ],
    rotation: [
      row(0, 0),
      row(0, 1),
      row(0, 2),
      row(3, 0),
      row(3, 1),
      row(3, 2),
      row(6, 0),
      row(6, 1),
      row(6, 2),
    ],
  };
}

function determinant([a, b, c, d, e, f, g, h, i]: Mat3): number {
  return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
}

/** LDraw (x, y, z) in LDU is (x, z, -y) in modules. */
function toModules(p: Vec3): Vec3 {
  const s = 1 / LDU_PER_MODULE;
  return [neat(p[0] * s), neat(p[2] * s), neat(-p[1] * s)];
}

/** The inverse of R -> M R M^T with M: (x, y, z) -> (x, -z, y). */
function toOurs(r: Mat3): Mat3 {
  const turned: Mat3 = [r[0], r[2], -r[1], r[6], r[8], -r[7], -r[3], -r[5], r[4]];
  return turned.map(neat) as unknown as Mat3;
}

/** Six decimals, and never -0. */
function neat(value: number): number {
  const rounded = Math.round(value * 1e6) / 1e6;
  return rounded === 0 ? 0 : rounded;
}

function modelText(name: string, parts: readonly PartRow[]): string {
  const rows = parts.map((part) => `    ${JSON.stringify(part)}`).join(',\n');
  return `{"format":"liftarm-model","version":1,"name":${JSON.stringify(name)},"parts":[\n${rows}\n]}\n`;
}
