import type { Vec3 } from '../geometry/vec.ts';

/** A line with new ends; without a number, a new line. */
export interface MendedLine {
  readonly line?: number;
  readonly from: Vec3;
  readonly to: Vec3;
}

/** What a person would want to know of a legal sketch; mirrors core/design/notes_json.h. */
export interface SketchNote {
  readonly kind: 'moved' | 'open' | 'near' | 'crossing' | 'pieces';
  /** One English sentence. */
  readonly message: string;
  readonly at: Vec3;
  readonly lines: readonly number[];
  /** What puts it right; empty where nothing simple does. */
  readonly mend: readonly MendedLine[];
}

const KINDS: ReadonlySet<unknown> = new Set(['moved', 'open', 'near', 'crossing', 'pieces']);

/** The notes in the core's answer about a sketch, in its order; nothing for a text of another form. */
export function readSketchNotes(answer: string): readonly SketchNote[] {
  let root: unknown;
  try {
    root = JSON.parse(answer);
  } catch {
    return [];
  }
  const list = (root as { notes?: unknown } | null)?.notes;
  return Array.isArray(list) ? list.filter(isNote) : [];
}

function isNote(value: unknown): value is SketchNote {
  const each = value as Partial<Record<keyof SketchNote, unknown>> | null;
  return (
    KINDS.has(each?.kind) &&
    typeof each?.message === 'string' &&
    isVector(each.at) &&
    isListOf(each.lines, Number.isInteger) &&
    isListOf(each.mend, isMended)
  );
}

function isMended(value: unknown): boolean {
  const each = value as Partial<Record<keyof MendedLine, unknown>> | null;
  const numbered = each?.line === undefined || Number.isInteger(each.line);
  return numbered && isVector(each?.from) && isVector(each?.to);
}

function isListOf(value: unknown, is: (each: unknown) => boolean): boolean {
  return Array.isArray(value) && value.every(is);
}

function isVector(value: unknown): value is Vec3 {
  return Array.isArray(value) && value.length === 3 && value.every((x) => Number.isFinite(x));
}
