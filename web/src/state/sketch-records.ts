import type { SketchDocument } from '../model/sketch.ts';
import { applyKept, isDelta } from './delta.ts';
import { EMPTY_HISTORY, type History, type HistoryEntry } from './history.ts';
import { readSketchValue } from './read-sketch.ts';
import { readSearchSettings, type SearchSettings } from './search-settings.ts';
import type { KeptRecord, Key, Reading, Writing } from './storage.ts';
import type { SavedSketch, Step } from './store.ts';

/**
 * How a sketch is kept: a head that says which revision is the newest; the sketch as a whole, at its beginning and
 * again now and then; and each step since. So an edit writes what it changed, however long the history is. Nothing
 * that is read is trusted: what is damaged costs what hangs on it, never the rest.
 */

const FORMAT = 2;
/** The sketch is written as a whole again after so many steps: none but these are gone through to show it. */
export const STEPS_PER_BASE = 64;
/** Wholes that are kept beside the first: should the newest be damaged there is another. */
const KEPT_BASES = 2;

/** Everything of a sketch that another visit finds again. */
export interface KeptState extends SavedSketch {
  /** What this sketch is searched with, should that not be what the person uses otherwise. */
  readonly settings: SearchSettings | null;
}

/** A step as it is written; settings are no part of the history that can be undone. */
export type KeptStep =
  | Step
  | { readonly kind: 'settings'; readonly settings: SearchSettings | null };

export interface Kept extends KeptState {
  readonly revision: number;
  /** Milliseconds since 1970; 0 when not known. */
  readonly changed: number;
  /** Whether all of it could be read. */
  readonly whole: boolean;
}

export interface Head {
  readonly id: string;
  readonly revision: number;
  readonly changed: number;
}

const headKey = (id: string): Key => ['head', id];

/** The heads of all sketches, the one changed last first. */
export async function readHeads(records: Reading): Promise<Head[]> {
  const found = await records.under(['head']);
  return found
    .flatMap(({ key, value }) => (typeof key[1] === 'string' ? [headOf(key[1], value)] : []))
    .sort((a, b) => b.changed - a.changed);
}

/** The newest revision of a sketch; 0 when there is none. */
export async function readRevision(records: Reading, id: string): Promise<number> {
  const head = await records.get(headKey(id));
  return head === undefined ? 0 : headOf(id, head).revision;
}

/** A head that is damaged stands for revision 0, which no sketch has: its steps say how far it goes. */
function headOf(id: string, value: unknown): Head {
  const { revision, changed } = isRecord(value) ? value : {};
  return { id, revision: wholeNumber(revision), changed: wholeNumber(changed) };
}

function wholeNumber(value: unknown): number {
  return Number.isSafeInteger(value) && Number(value) >= 0 ? Number(value) : 0;
}

/** Writes a sketch as a whole; what there was under its name is gone. @returns its revision. */
export function writeFirst(
  records: Writing,
  { id, changed }: Omit<Head, 'revision'>,
  state: KeptState,
): number {
  const revision = 1;
  const { sketch, history, settings } = state;
  deleteSketch(records, id);
  records.put(['base', id, revision], { sketch, history, settings });
  records.put(headKey(id), { format: FORMAT, revision, changed });
  return revision;
}

/** What is added to a sketch. */
export interface Addition {
  readonly steps: readonly KeptStep[];
  /** The sketch after them. */
  readonly after: KeptState;
  /** Writes the sketch as a whole whether it is time or not. */
  readonly anew: boolean;
}

/** Adds steps to the head that was read in the same transaction. @returns the new revision. */
export async function writeSteps(
  records: Writing,
  head: Head,
  { steps, after, anew }: Addition,
): Promise<number> {
  const { id, changed } = head;
  const revision = head.revision + steps.length;
  steps.forEach((step, i) => {
    records.put(['step', id, head.revision + 1 + i], step);
  });
  const turn = (at: number) => Math.floor(at / STEPS_PER_BASE);
  if (anew || turn(revision) > turn(head.revision)) {
    const bases = await records.under(['base', id]);
    const { sketch, history, settings } = after;
    records.put(
      ['base', id, revision],
      anew ? { sketch, history, settings } : { sketch, settings },
    );
    for (const { key } of bases.slice(1, -KEPT_BASES + 1)) {
      records.delete(key);
    }
  }
  records.put(headKey(id), { format: FORMAT, revision, changed });
  return revision;
}

/** Forgets a sketch for good. */
export function deleteSketch(records: Writing, id: string): void {
  records.delete(headKey(id));
  records.deleteUnder(['base', id]);
  records.deleteUnder(['step', id]);
}

/** A sketch as it was kept, or null when nothing of it can be read. */
export async function readKept(records: Reading, id: string): Promise<Kept | null> {
  const [head, bases, steps] = await Promise.all([
    records.get(headKey(id)),
    records.under(['base', id]),
    records.under(['step', id]),
  ]);
  return head === undefined ? null : replay(headOf(id, head), bases, steps);
}

interface Base {
  readonly at: number;
  readonly sketch: SketchDocument;
  readonly settings: SearchSettings | null;
  /** Where it was written with the sketch. */
  readonly history: History | null;
}

function replay(
  head: Head,
  baseRecords: readonly KeptRecord[],
  stepRecords: readonly KeptRecord[],
): Kept | null {
  const steps = new Map(stepRecords.map(({ key, value }) => [revisionOf(key), value]));
  const written = [...baseRecords, ...stepRecords].map(({ key }) => revisionOf(key));
  const last = head.revision || Math.max(0, ...written);
  const bases = baseRecords.flatMap((record) => readBase(record, last));
  const base = bases.at(-1);
  if (base === undefined) {
    return null;
  }
  const found = stateAt(base, steps, last);
  const past = historyAt(bases, steps, found.at);
  return {
    sketch: found.sketch,
    settings: found.settings,
    history: past.history,
    revision: head.revision,
    changed: head.changed,
    whole: head.revision > 0 && found.at === last && past.whole && bases.length > 0,
  };
}

function revisionOf(key: Key): number {
  return wholeNumber(key[2]);
}

function readBase({ key, value }: KeptRecord, last: number): Base[] {
  const at = revisionOf(key);
  const fields = isRecord(value) ? value : {};
  const sketch = readSketchValue(fields['sketch']);
  if (!sketch.ok || at > last) {
    return [];
  }
  const history = fields['history'] === undefined ? null : readHistory(fields['history']);
  return [{ at, sketch: sketch.value, settings: readSearchSettings(fields['settings']), history }];
}

interface Place {
  readonly sketch: SketchDocument;
  readonly settings: SearchSettings | null;
  readonly at: number;
}

/** The sketch after as many steps as can be read; all of them, if nothing is damaged. */
function stateAt(base: Base, steps: ReadonlyMap<number, unknown>, last: number): Place {
  const end = walk(base, steps, last, () => true);
  const readable = ({ sketch }: Place) => readSketchValue(sketch).ok;
  return readable(end) ? end : walk(base, steps, last, readable);
}

function walk(
  from: Place,
  steps: ReadonlyMap<number, unknown>,
  last: number,
  accept: (place: Place) => boolean,
): Place {
  let place = from;
  while (place.at < last) {
    const step = readStep(steps.get(place.at + 1));
    const next = step && afterStep(place, step);
    if (!next || !accept(next)) {
      break;
    }
    place = next;
  }
  return place;
}

/** @returns null when the step is about what the sketch does not have. */
function afterStep({ sketch, settings, at }: Place, step: KeptStep): Place | null {
  if (step.kind === 'settings') {
    return { sketch, settings: step.settings, at: at + 1 };
  }
  const next = applyKept(sketch, step.delta);
  return next && { sketch: next, settings, at: at + 1 };
}

/** What can be undone and done again at a revision. Where a step is damaged it begins anew. */
function historyAt(bases: readonly Base[], steps: ReadonlyMap<number, unknown>, until: number) {
  const first = bases.filter(({ history }) => history !== null).at(-1);
  const past = [...(first?.history?.past ?? [])];
  const future = [...(first?.history?.future ?? [])];
  let whole = first !== undefined;
  for (let at = (first?.at ?? bases[0]?.at ?? until) + 1; at <= until; at++) {
    const step = readStep(steps.get(at));
    if (step === null || !moveHistory(past, future, step)) {
      past.length = 0;
      future.length = 0;
      whole = false;
    }
  }
  return { history: { past, future }, whole };
}

/** @returns false when the step is about an entry that is not there. */
function moveHistory(past: HistoryEntry[], future: HistoryEntry[], step: KeptStep): boolean {
  if (step.kind === 'settings') {
    return true;
  }
  if (step.kind === 'push') {
    past.push({ label: step.label, delta: step.delta });
    future.length = 0;
    return true;
  }
  const [from, to] = step.kind === 'undo' ? [past, future] : [future, past];
  const entry = from.pop();
  if (entry === undefined) {
    return false;
  }
  to.push(entry);
  return true;
}

function readStep(value: unknown): KeptStep | null {
  if (!isRecord(value)) {
    return null;
  }
  const { kind, label, delta } = value;
  if (kind === 'settings') {
    return { kind, settings: readSearchSettings(value['settings']) };
  }
  if (!isDelta(delta)) {
    return null;
  }
  if (kind === 'push') {
    return typeof label === 'string' ? { kind, label, delta } : null;
  }
  return kind === 'undo' || kind === 'redo' ? { kind, delta } : null;
}

/** A history as it was written with a sketch; an empty one when it is damaged. */
export function readHistory(value: unknown): History {
  if (!isRecord(value) || !isEntries(value['past']) || !isEntries(value['future'])) {
    return EMPTY_HISTORY;
  }
  return { past: value['past'], future: value['future'] };
}

function isEntries(value: unknown): value is readonly HistoryEntry[] {
  return Array.isArray(value) && value.every(isEntry);
}

function isEntry(value: unknown): value is HistoryEntry {
  return isRecord(value) && typeof value['label'] === 'string' && isDelta(value['delta']);
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
