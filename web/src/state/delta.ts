import type { Keep } from '../model/keep.ts';
import type { Drive, Shaft } from '../model/shafts.ts';
import {
  type KeepOutBox,
  type SketchDocument,
  type SketchJoint,
  type SketchLine,
  type SketchSymmetry,
  versionOf,
} from '../model/sketch.ts';
import type { SketchColours } from '../model/sketch-colours.ts';
import { setKeep } from './keeps.ts';
import { setColours } from './paint-lines.ts';

/** One replaced stretch of a list: `removed` stood at `at` before, `added` stands there after. */
export interface Splice<T> {
  readonly at: number;
  readonly removed: readonly T[];
  readonly added: readonly T[];
}

/** A single value before and after; null stands for a field that is left out. */
export interface Change<T> {
  readonly before: T | null;
  readonly after: T | null;
}

/** An edit of a sketch that can be undone: it holds what was there and what is there now. */
export interface SketchDelta {
  readonly lines?: Splice<SketchLine>;
  readonly joints?: Splice<SketchJoint>;
  readonly symmetries?: Splice<SketchSymmetry>;
  readonly keepOut?: Splice<KeepOutBox>;
  readonly shafts?: Splice<Shaft>;
  readonly drives?: Splice<Drive>;
  readonly name?: Change<string>;
  readonly ground?: Change<number>;
  readonly colours?: Change<SketchColours>;
  readonly keep?: Change<readonly Keep[]>;
}

const LISTS = ['lines', 'joints', 'symmetries', 'keepOut', 'shafts', 'drives'] as const;

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

/** The smallest splice that turns `before` into `after`, or undefined when they are equal. */
export function diffList<T>(before: readonly T[], after: readonly T[]): Splice<T> | undefined {
  const shorter = Math.min(before.length, after.length);
  let at = 0;
  while (at < shorter && same(before[at], after[at])) {
    at++;
  }
  let tail = 0;
  while (
    tail < shorter - at &&
    same(before[before.length - 1 - tail], after[after.length - 1 - tail])
  ) {
    tail++;
  }
  const removed = before.slice(at, before.length - tail);
  const added = after.slice(at, after.length - tail);
  return removed.length === 0 && added.length === 0 ? undefined : { at, removed, added };
}

/** The delta that turns `before` into `after`. */
export function diffSketch(before: SketchDocument, after: SketchDocument): SketchDelta {
  const delta = {
    lines: diffList(before.lines, after.lines),
    joints: diffList(before.joints ?? [], after.joints ?? []),
    symmetries: diffList(before.symmetries ?? [], after.symmetries ?? []),
    keepOut: diffList(before.keepOut ?? [], after.keepOut ?? []),
    shafts: diffList(before.shafts ?? [], after.shafts ?? []),
    drives: diffList(before.drives ?? [], after.drives ?? []),
    name: diffValue(before.name, after.name),
    ground: diffValue(before.ground, after.ground),
    colours: diffValue(before.colours, after.colours),
    keep: diffValue(before.keep, after.keep),
  };
  // A field that did not change is left out, so that an empty delta is an empty object.
  return Object.fromEntries(Object.entries(delta).filter(([, change]) => change !== undefined));
}

/** True when the delta changes nothing. */
export function isEmptyDelta(delta: SketchDelta): boolean {
  return Object.keys(delta).length === 0;
}

/** The delta that undoes this one. */
export function invertDelta(delta: SketchDelta): SketchDelta {
  const inverse: Mutable<SketchDelta> = {};
  if (delta.lines) inverse.lines = invertSplice(delta.lines);
  if (delta.joints) inverse.joints = invertSplice(delta.joints);
  if (delta.symmetries) inverse.symmetries = invertSplice(delta.symmetries);
  if (delta.keepOut) inverse.keepOut = invertSplice(delta.keepOut);
  if (delta.shafts) inverse.shafts = invertSplice(delta.shafts);
  if (delta.drives) inverse.drives = invertSplice(delta.drives);
  if (delta.name) inverse.name = { before: delta.name.after, after: delta.name.before };
  if (delta.ground) inverse.ground = { before: delta.ground.after, after: delta.ground.before };
  if (delta.colours) inverse.colours = { before: delta.colours.after, after: delta.colours.before };
  if (delta.keep) inverse.keep = { before: delta.keep.after, after: delta.keep.before };
  return inverse;
}

/**
 * The sketch after the delta. Lists that end up empty are left out, as the format allows.
 * The delta must have been made for this sketch; see `invertDelta` for the way back.
 */
export function applyDelta(sketch: SketchDocument, delta: SketchDelta): SketchDocument {
  const next: Mutable<SketchDocument> = { ...sketch };
  if (delta.lines) {
    next.lines = applySplice(sketch.lines, delta.lines);
  }
  setList(next, 'joints', delta.joints && applySplice(sketch.joints ?? [], delta.joints));
  setList(
    next,
    'symmetries',
    delta.symmetries && applySplice(sketch.symmetries ?? [], delta.symmetries),
  );
  setList(next, 'keepOut', delta.keepOut && applySplice(sketch.keepOut ?? [], delta.keepOut));
  setList(next, 'shafts', delta.shafts && applySplice(sketch.shafts ?? [], delta.shafts));
  setList(next, 'drives', delta.drives && applySplice(sketch.drives ?? [], delta.drives));
  setValue(next, 'name', delta.name);
  setValue(next, 'ground', delta.ground);
  const kept = delta.keep ? setKeep(next, delta.keep.after ?? []) : next;
  return withColours(ofVersion(kept, delta), delta.colours);
}

/** Ranges of joints are of version 2, and so are shafts. */
function ofVersion(sketch: SketchDocument, { joints, shafts }: SketchDelta): SketchDocument {
  return joints || shafts ? { ...sketch, version: versionOf(sketch) } : sketch;
}

function setValue<K extends 'name' | 'ground'>(
  sketch: Mutable<SketchDocument>,
  key: K,
  change: Change<NonNullable<SketchDocument[K]>> | undefined,
): void {
  if (change?.after === null) {
    delete sketch[key];
  } else if (change) {
    sketch[key] = change.after;
  }
}

function withColours(
  sketch: SketchDocument,
  change: Change<SketchColours> | undefined,
): SketchDocument {
  return change ? setColours(sketch, change.after) : sketch;
}

/** Whether a value from outside is a delta. */
export function isDelta(value: unknown): value is SketchDelta {
  if (!isRecord(value)) {
    return false;
  }
  const { name, ground, colours, keep } = value;
  return (
    LISTS.every((key) => value[key] === undefined || isSplice(value[key])) &&
    (name === undefined || isChange(name, 'string')) &&
    (ground === undefined || isChange(ground, 'number')) &&
    (colours === undefined || isChange(colours, 'object')) &&
    (keep === undefined || isChange(keep, 'object'))
  );
}

/** Whether a sketch has what a delta replaces. */
function fitsDelta(sketch: SketchDocument, delta: SketchDelta): boolean {
  return LISTS.every((key) => {
    const splice = delta[key];
    return !splice || splice.at + splice.removed.length <= (sketch[key]?.length ?? 0);
  });
}

/** The sketch after a delta that was kept and may be damaged however deep, or null where it is about another sketch. */
export function applyKept(sketch: SketchDocument, delta: SketchDelta): SketchDocument | null {
  try {
    return fitsDelta(sketch, delta) ? applyDelta(sketch, delta) : null;
  } catch {
    return null;
  }
}

function isSplice(value: unknown): boolean {
  return (
    isRecord(value) &&
    Number.isSafeInteger(value['at']) &&
    Number(value['at']) >= 0 &&
    Array.isArray(value['removed']) &&
    Array.isArray(value['added'])
  );
}

function isChange(value: unknown, type: 'string' | 'number' | 'object'): boolean {
  const known = (side: unknown) => side === null || typeof side === type;
  return isRecord(value) && known(value['before']) && known(value['after']);
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

type ListKey = 'joints' | 'symmetries' | 'keepOut' | 'shafts' | 'drives';

function setList<K extends ListKey>(
  sketch: Mutable<SketchDocument>,
  key: K,
  list: SketchDocument[K] | undefined,
): void {
  if (list === undefined) {
    return;
  }
  if (list.length === 0) {
    delete sketch[key];
    return;
  }
  sketch[key] = list;
}

function diffValue<T>(before: T | undefined, after: T | undefined): Change<T> | undefined {
  return same(before, after) ? undefined : { before: before ?? null, after: after ?? null };
}

function applySplice<T>(list: readonly T[], splice: Splice<T>): T[] {
  const end = splice.at + splice.removed.length;
  return [...list.slice(0, splice.at), ...splice.added, ...list.slice(end)];
}

function invertSplice<T>(splice: Splice<T>): Splice<T> {
  return { at: splice.at, removed: splice.added, added: splice.removed };
}

function same(a: unknown, b: unknown): boolean {
  return a === b || JSON.stringify(a) === JSON.stringify(b);
}
