import type { Mat3, Vec3 } from '../geometry/vec.ts';
import { BRICK_COLOURS, FALLBACK_COLOUR_CODE, findColour } from '../model/colours.ts';
import { linesOf } from '../model/delimited.ts';

const MAX_FILES = 20_000;
/** The colour of what holds it, and that of its edges, which is no colour of a part. */
export const INHERITED_COLOURS = [16, 24];

/** A place in LDraw's own coordinates: position in LDU, rotation row by row. */
export interface Place {
  readonly position: Vec3;
  readonly rotation: Mat3;
  readonly color: number;
}

/** A row of type 1. */
export interface Row extends Place {
  readonly file: string;
}

/** One file of a document. */
export interface LdrawFile {
  readonly rows: Row[];
  /** Its lines and surfaces as they stand there: rows of the types 2, 3 and 4. */
  readonly drawn: string[];
  /** What its first note says. */
  title: string;
}

/** What is wrong with the file. */
export class Refusal extends Error {}

/** Names are told apart without regard to case and to how much white space they hold. */
export function keyOf(name: string): string {
  return name.trim().replace(/\s+/g, ' ').toLowerCase();
}

/** The files of a document in their order. Of two with one name the first counts, as everywhere in LDraw. */
export function readFiles(text: string, note: (sentence: string) => void): Map<string, LdrawFile> {
  const files = new Map<string, LdrawFile>();
  for (const { key, ...file } of sectionsOf(text)) {
    if (files.has(key)) {
      note(`${key} stands there more than once; the first counts`);
    } else {
      files.set(key, file);
    }
    if (files.size > MAX_FILES) {
      throw new Refusal(`more than ${MAX_FILES} submodels, which is the limit`);
    }
  }
  return files;
}

interface Section extends LdrawFile {
  readonly key: string;
}

function emptySection(key: string): Section {
  return { key, rows: [], drawn: [], title: '' };
}

/** Rows before the first FILE are a file of their own; those after a NOFILE belong to none. */
function sectionsOf(text: string): Section[] {
  const leading = emptySection('model.ldr');
  const sections: Section[] = [];
  let open: Section | null = leading;
  linesOf(text).forEach((line, i) => {
    const named = /^\s*0\s+FILE\s(.+)$/is.exec(line);
    if (named?.[1]) {
      open = emptySection(keyOf(named[1]));
      sections.push(open);
    } else if (/^\s*0\s+NOFILE\b/i.test(line)) {
      open = null;
    } else if (open) {
      take(open, line, i);
    }
  });
  return leading.rows.length > 0 ? [leading, ...sections] : sections;
}

function take(section: Section, line: string, index: number): void {
  if (/^\s*1\s/.test(line)) {
    section.rows.push(readRow(line, index));
  } else if (/^\s*[234]\s/.test(line)) {
    section.drawn.push(line);
  } else if (section.title === '') {
    section.title = /^\s*0\s+([^!\s].*)$/.exec(line)?.[1]?.trim() ?? '';
  }
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
