import { bad, good, type Outcome } from '../base/outcome.ts';
import type { Mat3, Vec3 } from '../geometry/vec.ts';
import { type GuestKind, readGuestKinds } from '../model/guests.ts';
import type { Model, PlacedPart } from '../model/model.ts';
import { fillWords } from '../tools/tool-words.ts';
import { text } from '../ui/text.ts';

// The limits of the core (core/model/model_json.h).
const MAX_PARTS = 100_000;
const MAX_POSITION = 5000;
const MAX_WHOLE = 1e6;
const MAX_NAME = 1000;

/** Reads the text of a model file as far as the picture and the parts list need it. */
export function readModel(json: string): Outcome<Model> {
  let value: unknown;
  try {
    value = JSON.parse(json);
  } catch {
    return bad(text.files.notJson);
  }
  if (typeof value !== 'object' || value === null || !('parts' in value)) {
    return bad(text.files.neither);
  }
  const { format, version } = value as { readonly format?: unknown; readonly version?: unknown };
  if (format !== 'liftarm-model' || version !== 1) {
    return bad(text.files.neither);
  }
  const rows: unknown = value.parts;
  if (!Array.isArray(rows) || rows.length > MAX_PARTS) {
    return bad(text.files.neither);
  }
  const { rows: guestRows, kinds } = guestsIn(value);
  const parts: PlacedPart[] = [];
  for (const [i, row] of [...rows, ...guestRows].entries()) {
    const part = readPart(row);
    if (!part) {
      return bad(fillWords(text.files.badModel, { i }));
    }
    parts.push(part);
  }
  const name: unknown = 'name' in value ? value.name : '';
  return typeof name === 'string' && name.length <= MAX_NAME
    ? good({ name, parts, ...(kinds.length > 0 && { guests: { count: guestRows.length, kinds } }) })
    : bad(text.files.neither);
}

/** Parts that the core does not know (model/guests.ts); none where they are not in their form. */
function guestsIn(file: object): { rows: readonly unknown[]; kinds: readonly GuestKind[] } {
  const none = { rows: [], kinds: [] };
  const guests: unknown = 'guests' in file ? file.guests : null;
  if (typeof guests !== 'object' || guests === null) {
    return none;
  }
  const { kinds, parts } = guests as { readonly kinds?: unknown; readonly parts?: unknown };
  const known = readGuestKinds(kinds);
  return known && Array.isArray(parts) && parts.length <= MAX_PARTS
    ? { rows: parts, kinds: known }
    : none;
}

function readPart(row: unknown): PlacedPart | null {
  if (typeof row !== 'object' || row === null) {
    return null;
  }
  const { part, color, position, rotation, component, layer, piece } = row as Record<
    string,
    unknown
  >;
  const placed = isNumbers(position, 3) && isNumbers(rotation, 9);
  if (typeof part !== 'string' || !placed || ![color, component, layer, piece].every(isWhole)) {
    return null;
  }
  return {
    part,
    color: numberOr(color, 71),
    position: position as unknown as Vec3,
    rotation: rotation as unknown as Mat3,
    component: numberOr(component, -1),
    layer: numberOr(layer, 0),
    piece: numberOr(piece, 0),
  };
}

function isNumbers(value: unknown, count: number): value is readonly number[] {
  return (
    Array.isArray(value) &&
    value.length === count &&
    value.every((x) => Number.isFinite(x) && Math.abs(x) <= MAX_POSITION)
  );
}

/** A whole number, or none at all. */
function isWhole(value: unknown): boolean {
  return value === undefined || (Number.isInteger(value) && Math.abs(Number(value)) <= MAX_WHOLE);
}

function numberOr(value: unknown, other: number): number {
  return typeof value === 'number' && Number.isFinite(value) ? value : other;
}
