import { bad, good, type Outcome } from '../base/outcome.ts';
import type { Mat3, Vec3 } from '../geometry/vec.ts';
import type { Model, PlacedPart } from '../model/model.ts';
import { fillWords } from '../tools/tool-words.ts';
import { text } from '../ui/text.ts';

const MAX_PARTS = 200_000;

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
  const rows: unknown = value.parts;
  if (!Array.isArray(rows) || rows.length > MAX_PARTS) {
    return bad(text.files.neither);
  }
  const parts: PlacedPart[] = [];
  for (const [i, row] of rows.entries()) {
    const part = readPart(row);
    if (!part) {
      return bad(fillWords(text.files.badModel, { i }));
    }
    parts.push(part);
  }
  const name = 'name' in value && typeof value.name === 'string' ? value.name : '';
  return good({ name, parts });
}

function readPart(row: unknown): PlacedPart | null {
  if (typeof row !== 'object' || row === null) {
    return null;
  }
  const { part, color, position, rotation, component, layer, piece } = row as Record<
    string,
    unknown
  >;
  if (typeof part !== 'string' || !isNumbers(position, 3) || !isNumbers(rotation, 9)) {
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
  return Array.isArray(value) && value.length === count && value.every(Number.isFinite);
}

function numberOr(value: unknown, other: number): number {
  return typeof value === 'number' && Number.isFinite(value) ? value : other;
}
