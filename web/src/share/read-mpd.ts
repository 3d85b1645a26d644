import { bad, good, type Outcome } from '../base/outcome.ts';
import { add, type Mat3, rotate, type Vec3 } from '../geometry/vec.ts';
import type { Catalogue } from '../model/catalogue.ts';
import { linesOf } from '../model/delimited.ts';
import type { GuestKind } from '../model/guests.ts';
import { mirrorPlane } from '../model/mirror-plane.ts';
import { plainNumber } from '../model/part-synonyms.ts';
import { guestKind, type KnownSizes } from './ldraw-guests.ts';
import { LdrawLeaves, MAX_DEPTH } from './ldraw-leaves.ts';
import { INHERITED_COLOURS, type LdrawFile, type Place, Refusal, readFiles } from './ldraw-rows.ts';
import { compose, determinant, neat, toModules, toOurs } from './ldraw-space.ts';

const MAX_PARTS = 200_000;
/** Visits: submodels that refer to each other many times are few rows in the file. */
const MAX_ROWS = 400_000;
/** Rows that are followed, counted before any is: submodels multiply, with or without a part in them. */
const MAX_VISITS = 400_000;
const NAMED_AT_MOST = 24;

interface PartRow {
  readonly part: string;
  readonly color: number;
  readonly position: Vec3;
  readonly rotation: Mat3;
}

/** What may be said of parts that the catalogue does not hold. */
export interface MpdHelp {
  /** Told what was left out or taken otherwise than it stands there, one sentence each. */
  readonly note?: (sentence: string) => void;
  /** Names and boxes of parts by their number. */
  readonly sizes?: KnownSizes;
  /** What the model is called; by its first file where this is left out or empty. */
  readonly name?: string;
}

/**
 * Reads an LDraw document: the parts that the catalogue knows, under any of their numbers, and the others as guests
 * (model/guests.ts).
 * @returns the text of a model file without a sketch, or one sentence that names the place.
 */
export function readMpd(
  text: string,
  catalogue: Catalogue,
  { note = () => undefined, sizes = {}, name = '' }: MpdHelp = {},
): Outcome<string> {
  try {
    const files = readFiles(text, note);
    const main = files.keys().next().value;
    if (main === undefined) {
      return bad('the file holds no parts (lines that begin with "1")');
    }
    const root: Place = { position: [0, 0, 0], rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], color: 7 };
    const leaves = new LdrawLeaves(files, catalogue);
    if (countVisits(leaves, main, [], new Map()) > MAX_VISITS) {
      throw new Refusal(`submodels and parts are more than ${MAX_VISITS}, which is the limit`);
    }
    const reader = new Placer(leaves, catalogue);
    reader.place(main, root);
    const left = reader.leftOut();
    if (reader.parts.length === 0) {
      return bad(left[0] ?? 'the file holds no parts (lines that begin with "1")');
    }
    left.forEach(note);
    const kinds = reader.guestFiles().map(([id, file]) => guestKind(id, file, files, sizes));
    return good(modelText(name || main.replace(/\.(ldr|mpd|dat)$/i, ''), reader, kinds));
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

/**
 * How many rows are followed from a file down, each as often as it is come by.
 * @param path the files that hold this one.
 */
function countVisits(
  leaves: LdrawLeaves,
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
    for (const row of leaves.files.get(file)?.rows ?? []) {
      const inside = leaves.isSubmodel(row.file);
      count += 1 + (inside ? countVisits(leaves, row.file, [...path, file], known) : 0);
    }
    known.set(file, count);
  }
  return count;
}

/** Follows submodels down to parts. */
class Placer {
  readonly #leaves: LdrawLeaves;
  readonly #files: ReadonlyMap<string, LdrawFile>;
  readonly #catalogue: Catalogue;
  readonly #missing = new Set<string>();
  /** Files of parts that are not known, by their number. */
  readonly #unknown = new Map<string, string>();
  #rows = 0;
  readonly parts: PartRow[] = [];
  /** Parts that are not known. */
  readonly guests: PartRow[] = [];

  constructor(leaves: LdrawLeaves, catalogue: Catalogue) {
    this.#leaves = leaves;
    this.#files = leaves.files;
    this.#catalogue = catalogue;
  }

  /** Numbers and files of the parts that are not known. */
  guestFiles(): (readonly [id: string, file: string])[] {
    return [...this.#unknown];
  }

  /** What could not be placed or is not known, one sentence each. */
  leftOut(): string[] {
    const counts = new Map<string, number>();
    for (const { part } of this.guests) {
      counts.set(part, (counts.get(part) ?? 0) + 1);
    }
    const rows = [...counts].slice(0, NAMED_AT_MOST).map(([id, n]) => `${id} (${n})`);
    const parts = `${rows.join(', ')}${counts.size > rows.length ? ', …' : ''}`;
    const [missing] = this.#missing;
    return [
      ...(rows.length > 0 ? [`parts that are not known here are not judged: ${parts}`] : []),
      ...(missing === undefined ? [] : [`what stands in another file is left out: ${missing}`]),
    ];
  }

  place(file: string, at: Place): void {
    for (const row of this.#files.get(file)?.rows ?? []) {
      this.#rows += 1;
      if (this.#rows > MAX_ROWS) {
        throw new Refusal(
          `more than ${MAX_ROWS} rows with all submodels in place, which is the limit`,
        );
      }
      const color = INHERITED_COLOURS.includes(row.color) ? at.color : row.color;
      const place = { ...compose(at, row), color };
      if (this.#leaves.isSubmodel(row.file)) {
        this.place(row.file, place);
      } else {
        this.#add(row.file, place);
      }
    }
  }

  #add(file: string, place: Place): void {
    const part = this.#leaves.known(file);
    if (part === null && !this.#files.has(file) && /\.(ldr|mpd)$/.test(file)) {
      this.#missing.add(file.slice(0, 60));
      return;
    }
    if (this.parts.length + this.guests.length >= MAX_PARTS) {
      throw new Refusal(`more than ${MAX_PARTS} parts, which is the limit`);
    }
    const position = toModules(place.position);
    const rotation = toOurs(place.rotation);
    if (part === null) {
      const id = plainNumber(file).slice(0, 40);
      this.#unknown.set(id, this.#unknown.get(id) ?? file);
      this.guests.push({ part: id, color: place.color, position, rotation });
    } else {
      const { color } = place;
      this.parts.push({ part, color, ...this.#proper(part, position, rotation) });
    }
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

function modelText(name: string, { parts, guests }: Placer, kinds: readonly GuestKind[]): string {
  const rows = (list: readonly unknown[]) =>
    list.map((part) => `    ${JSON.stringify(part)}`).join(',\n');
  const others =
    guests.length === 0
      ? ''
      : `,\n"guests":{"kinds":[\n${rows(kinds)}\n],"parts":[\n${rows(guests)}\n]}`;
  return `{"format":"liftarm-model","version":1,"name":${JSON.stringify(name)},"parts":[\n${rows(parts)}\n]${others}}\n`;
}
