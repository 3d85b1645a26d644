import { bad, good, type Outcome } from '../base/outcome.ts';
import type { Mat3, Vec3 } from '../geometry/vec.ts';

const LDU_PER_MODULE = 20;
const MAX_PARTS = 200_000;
/** Visits: submodels that refer to each other many times are few rows in the file. */
const MAX_ROWS = 400_000;
const MAX_DEPTH = 8;
const MAX_FILES = 20_000;
/** Rows that are followed, counted before any is: submodels multiply, with or without a part in them. */
const MAX_VISITS = 400_000;
const MAIN_COLOUR = 16;

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

/** Says which part numbers there are, as a catalogue does. */
export interface KnownParts {
  find(part: string): unknown;
}

/** What is wrong with the file. */
class Refusal extends Error {}

/**
 * Reads an LDraw multi-part document whose parts are all in the catalogue, as this program writes it.
 * @returns the text of a model file without a sketch, or one sentence that names the place.
 */
export function readMpd(text: string, catalogue: KnownParts): Outcome<string> {
  try {
    const files = readFiles(text);
    const main = files.keys().next().value;
    if (main === undefined) {
      return bad('the file holds no parts (lines that begin with "1")');
    }
    const parts: PartRow[] = [];
    const root: Place = { position: [0, 0, 0], rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], color: 7 };
    const reader = new Placer(files, catalogue, parts);
    if (countVisits(files, main) > MAX_VISITS) {
      throw new Refusal(`submodels and parts are more than ${MAX_VISITS}, which is the limit`);
    }
    reader.place(main, root, 0);
    if (parts.length === 0) {
      return bad('the file holds no parts (lines that begin with "1")');
    }
    const name = main.replace(/\.(ldr|mpd|dat)$/i, '');
    return good(modelText(name, parts));
  } catch (error) {
    if (error instanceof Refusal) {
      return bad(error.message);
    }
    throw error;
  }
}

/** Whether a text looks like an LDraw file: it begins with a comment or a part. */
export function looksLikeMpd(text: string): boolean {
  return /^\uFEFF?\s*(0 (FILE|Name:|!|BFC|[^\n]*)|1( -?[\d.]+){13} \S)/i.test(text.slice(0, 4096));
}

/** Names are told apart without regard to case and to how much white space they hold. */
function keyOf(name: string): string {
  return name.trim().replace(/\s+/g, ' ').toLowerCase();
}

/** The files of a document in their order. Of two with one name the first counts, as everywhere in LDraw. */
function readFiles(text: string): Map<string, Row[]> {
  const files = new Map<string, Row[]>();
  for (const { key, rows } of sectionsOf(text)) {
    if (!files.has(key)) {
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
  text.split(/\r?\n/).forEach((line, i) => {
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
  const numbers = fields.slice(1, 14).map(Number);
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

/** How many rows are followed from a file down, each as often as it is come by. */
function countVisits(
  files: ReadonlyMap<string, readonly Row[]>,
  file: string,
  depth = 0,
  known = new Map<string, number>(),
): number {
  if (depth > MAX_DEPTH) {
    throw new Refusal(`${file}: submodels are nested more than ${MAX_DEPTH} deep`);
  }
  let count = known.get(file);
  if (count === undefined) {
    count = 0;
    for (const row of files.get(file) ?? []) {
      count += 1 + (files.has(row.file) ? countVisits(files, row.file, depth + 1, known) : 0);
    }
    known.set(file, count);
  }
  return count;
}

/** Follows submodels down to parts. */
class Placer {
  readonly #files: ReadonlyMap<string, readonly Row[]>;
  readonly #catalogue: KnownParts;
  readonly #parts: PartRow[];
  #rows = 0;

  constructor(files: ReadonlyMap<string, readonly Row[]>, catalogue: KnownParts, parts: PartRow[]) {
    this.#files = files;
    this.#catalogue = catalogue;
    this.#parts = parts;
  }

  place(file: string, at: Place, depth: number): void {
    if (depth > MAX_DEPTH) {
      throw new Refusal(`${file}: submodels are nested more than ${MAX_DEPTH} deep`);
    }
    for (const row of this.#files.get(file) ?? []) {
      this.#rows += 1;
      if (this.#rows > MAX_ROWS) {
        throw new Refusal(
          `more than ${MAX_ROWS} rows with all submodels in place, which is the limit`,
        );
      }
      const color = row.color === MAIN_COLOUR ? at.color : row.color;
      const place = { ...compose(at, row), color };
      if (this.#files.has(row.file)) {
        this.place(row.file, place, depth + 1);
      } else {
        this.#add(row.file, place);
      }
    }
  }

  #add(file: string, place: Place): void {
    // Some programs write the folder of the library before the name.
    const part = file.replace(/^.*[\\/]/, '').replace(/\.(dat|ldr)$/, '');
    if (!this.#catalogue.find(part)) {
      throw new Refusal(`part ${part.slice(0, 40)} is not in the catalogue`);
    }
    if (this.#parts.length >= MAX_PARTS) {
      throw new Refusal(`more than ${MAX_PARTS} parts, which is the limit`);
    }
    this.#parts.push({
      part,
      color: place.color,
      position: toModules(place.position),
      rotation: toOurs(place.rotation),
    });
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
