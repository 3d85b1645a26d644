import type { Vec3 } from '../geometry/vec.ts';
import type { Part } from './catalogue.ts';
import type { Model, PlacedPart } from './model.ts';

// Parts that files of others hold and the catalogue does not. They are shown, counted and put on, and never judged: the
// core does not see them. A model file has them beside its parts, under `guests`; in a Model they follow its parts, so
// that the numbers of parts are those of the core.

/** A kind of part that is not in the catalogue; its own frame, modules. */
export interface GuestKind {
  readonly id: string;
  readonly name: string;
  readonly min: Vec3;
  readonly max: Vec3;
  /** Corners of triangles, nine numbers each; empty: a box stands for it. */
  readonly faces: readonly number[];
  /** Ends of lines that are drawn, six numbers each. */
  readonly lines: readonly number[];
}

/** The limits of what a model file may say of guests. */
const MAX_KINDS = 2000;
const MAX_NUMBERS = 2_000_000;
const MAX_POSITION = 5000;
const MAX_NAME = 200;

/** The kinds of a model file, or null where they are not in their form. */
export function readGuestKinds(value: unknown): GuestKind[] | null {
  if (!Array.isArray(value) || value.length > MAX_KINDS) {
    return null;
  }
  const kinds: GuestKind[] = [];
  let numbers = 0;
  for (const row of value as readonly unknown[]) {
    const kind = readKind(row);
    numbers += kind ? kind.faces.length + kind.lines.length : 0;
    if (!kind || numbers > MAX_NUMBERS) {
      return null;
    }
    kinds.push(kind);
  }
  return kinds;
}

function readKind(row: unknown): GuestKind | null {
  if (typeof row !== 'object' || row === null) {
    return null;
  }
  const { id, name, min, max, faces = [], lines = [] } = row as Record<string, unknown>;
  const named = [id, name].every((word) => typeof word === 'string' && word.length <= MAX_NAME);
  const shaped = isNumbers(faces, 9) && isNumbers(lines, 6);
  const boxed = isNumbers(min, 3) && isNumbers(max, 3) && min.length + max.length === 6;
  return named && shaped && boxed && min.every((low, i) => low <= (max[i] ?? low))
    ? { id: String(id), name: String(name), min: triple(min), max: triple(max), faces, lines }
    : null;
}

/** Numbers in rows of so many. */
function isNumbers(value: unknown, each: number): value is readonly number[] {
  return (
    Array.isArray(value) &&
    value.length % each === 0 &&
    value.every((x) => typeof x === 'number' && Math.abs(x) <= MAX_POSITION)
  );
}

function triple([x = 0, y = 0, z = 0]: readonly number[]): Vec3 {
  return [x, y, z];
}

/** A kind as a part of the catalogue that joins nothing and fills nothing. */
export function guestPart(kind: GuestKind): Part {
  return {
    id: kind.id,
    name: kind.name,
    partClass: 'connector',
    mass: 0,
    massEstimated: true,
    friction: false,
    color: 7,
    holes: 0,
    thickness: 1,
    features: [],
    stretches: [],
    solid: [],
    collars: [],
    boundsMin: kind.min,
    boundsMax: kind.max,
    guest: kind,
  };
}

/** How many parts of a model are guests. */
export function countGuests(model: Pick<Model, 'guests'>): number {
  return model.guests?.count ?? 0;
}

/** The text of a model file with its guests among its parts, for what only counts and places them. */
export function withGuestsAsParts(json: string): string {
  const file = JSON.parse(json) as { parts: PlacedPart[]; guests?: { parts: PlacedPart[] } };
  const { guests, ...rest } = file;
  return guests ? JSON.stringify({ ...rest, parts: [...file.parts, ...guests.parts] }) : json;
}
