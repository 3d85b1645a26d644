import type { Vec3 } from '../geometry/vec.ts';

// What turns in a sketch of version 2 (docs/shafts.md); core/sketch/shaft_json.h is the authority.

/** What sits at an end of a shaft. */
export type ShaftEnd = 'crank' | 'wheel';
export const SHAFT_ENDS: readonly ShaftEnd[] = ['crank', 'wheel'];

/** An axle that turns in the holes of the lines that it crosses: each node from its first to its last is a slot. */
export interface Shaft {
  readonly from: Vec3;
  readonly to: Vec3;
  readonly atFrom?: ShaftEnd;
  readonly atTo?: ShaftEnd;
}

/** A shaft with nothing but the keys that it has. */
export function plainShaft({ from, to, atFrom, atTo }: Shaft): Shaft {
  return { from, to, ...(atFrom ? { atFrom } : {}), ...(atTo ? { atTo } : {}) };
}

/** Two shafts that gears couple, by their numbers. */
export interface Drive {
  readonly from: number;
  readonly to: number;
  /** Turns of the first for one turn of the second. */
  readonly ratio: number;
  /** Per cent that the ratio may be off; 3 when left out. */
  readonly tolerance?: number;
}

/** Slots of the longest axle. */
export const MAX_SHAFT_SLOTS = 12;
export const MAX_RATIO = 1000;
const MOST = 100;
const MAX_COORDINATE = 2000;
const MAX_TOLERANCE = 50;

/** What is wrong with the members `shafts` and `drives` of a file, or null. */
export function shaftsFault(shafts: unknown, drives: unknown): string | null {
  const count = Array.isArray(shafts) ? shafts.length : 0;
  return (
    listFault(shafts, 'shafts', shaftFault) ??
    listFault(drives, 'drives', (drive, place) => driveFault(drive, place, count))
  );
}

function listFault(
  value: unknown,
  place: string,
  fault: (item: Record<string, unknown>, place: string) => string | null,
): string | null {
  if (value === undefined) {
    return null;
  }
  if (!Array.isArray(value)) {
    return `${place}: should be a list`;
  }
  if (value.length > MOST) {
    return `${place}: ${value.length} entries, at most ${MOST} are allowed`;
  }
  for (const [i, item] of (value as readonly unknown[]).entries()) {
    const where = `${place}[${i}]`;
    if (typeof item !== 'object' || item === null || Array.isArray(item)) {
      return `${where}: should be an object`;
    }
    const wrong = fault(item as Record<string, unknown>, where);
    if (wrong !== null) {
      return wrong;
    }
  }
  return null;
}

function shaftFault(shaft: Record<string, unknown>, place: string): string | null {
  const { from, to } = shaft;
  const strange = (['atFrom', 'atTo'] as const).find(
    (key) => shaft[key] !== undefined && !SHAFT_ENDS.includes(shaft[key] as ShaftEnd),
  );
  const fault =
    endFault(from, `${place}.from`) ??
    endFault(to, `${place}.to`) ??
    (strange ? `${place}.${strange}: expected "crank" or "wheel"` : null);
  if (fault !== null) {
    return fault;
  }
  const lengths = [0, 1, 2].map((k) =>
    Math.abs(Number((to as Vec3)[k]) - Number((from as Vec3)[k])),
  );
  const along = lengths.filter((length) => length > 0);
  if (along.length === 0) {
    return `${place}: the ends are the same point; a shaft is at least 1 module long`;
  }
  if (along.length > 1) {
    return `${place}: a shaft is parallel to x, y or z`;
  }
  const [length = 0] = along;
  return length < MAX_SHAFT_SLOTS
    ? null
    : `${place}: ${length} modules long; the longest axle reaches over ${MAX_SHAFT_SLOTS - 1}`;
}

function endFault(value: unknown, place: string): string | null {
  if (!Array.isArray(value) || value.length !== 3) {
    return `${place}: should be three numbers`;
  }
  for (const coordinate of value as readonly unknown[]) {
    if (typeof coordinate !== 'number' || Math.abs(coordinate) > MAX_COORDINATE) {
      return `${place}: should be a number`;
    }
    if (!Number.isInteger(coordinate)) {
      return `${place}: ${coordinate} is not on the lattice; shafts lie on whole modules`;
    }
  }
  return null;
}

function driveFault(drive: Record<string, unknown>, place: string, count: number): string | null {
  const { from, to, ratio, tolerance } = drive;
  const unknown = (['from', 'to'] as const).find((key) => {
    const index = drive[key];
    return !Number.isInteger(index) || Number(index) < 0 || Number(index) >= count;
  });
  if (unknown !== undefined) {
    return `${place}.${unknown}: expected the number of a shaft; there are ${count}, from 0`;
  }
  if (typeof ratio !== 'number' || ratio < 1 / MAX_RATIO || ratio > MAX_RATIO) {
    return `${place}.ratio: should be a number from 0.001 to ${MAX_RATIO}`;
  }
  if (
    tolerance !== undefined &&
    (typeof tolerance !== 'number' || tolerance < 0 || tolerance > MAX_TOLERANCE)
  ) {
    return `${place}.tolerance: should be a number from 0 to ${MAX_TOLERANCE}`;
  }
  return from === to ? `${place}: couples a shaft with itself` : null;
}
