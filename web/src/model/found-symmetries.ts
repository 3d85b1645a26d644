import type { Vec3 } from '../geometry/vec.ts';
import type { SketchSymmetry } from './sketch.ts';

/** A turn that brings a sketch onto itself. A sketch file has no name for it: it is only said. */
export interface RotationSymmetry {
  readonly kind: 'rotation';
  readonly axis: Vec3;
  readonly point: Vec3;
  /** So many turns of 360 / order degrees lead back. */
  readonly order: number;
}

/** A symmetry that a sketch has but does not name yet; mirrors core/design/symmetries.h. */
export type FoundSymmetry = SketchSymmetry | RotationSymmetry;

/** What the core's answer about symmetries holds, in its order; nothing for a text of another form. */
export function readFoundSymmetries(answer: string): readonly FoundSymmetry[] {
  let root: unknown;
  try {
    root = JSON.parse(answer);
  } catch {
    return [];
  }
  const list = (root as { symmetries?: unknown } | null)?.symmetries;
  return Array.isArray(list) ? list.filter(isFoundSymmetry) : [];
}

function isFoundSymmetry(value: unknown): value is FoundSymmetry {
  const each = value as Record<string, unknown> | null;
  switch (each?.['kind']) {
    case 'reflection':
      return isVector(each['normal']) && typeof each['offset'] === 'number';
    case 'translation':
      return isVector(each['vector']) && Array.isArray(each['pairs']);
    case 'rotation':
      return isVector(each['axis']) && isVector(each['point']) && Number.isInteger(each['order']);
    default:
      return false;
  }
}

function isVector(value: unknown): value is Vec3 {
  return Array.isArray(value) && value.length === 3 && value.every((x) => Number.isFinite(x));
}

/** Whether two are the same plane or shift, whatever lines they name. */
export function isSameSymmetry(a: FoundSymmetry, b: FoundSymmetry): boolean {
  const near = (p: Vec3, q: Vec3) => p.every((x, i) => Math.abs(x - (q[i] ?? 0)) < 1e-6);
  if (a.kind === 'reflection' && b.kind === 'reflection') {
    const same = near(a.normal, b.normal) && Math.abs(a.offset - b.offset) < 1e-6;
    return same && `${a.lines ?? ''}` === `${b.lines ?? ''}`;
  }
  if (a.kind === 'translation' && b.kind === 'translation') {
    return near(a.vector, b.vector) && `${a.pairs}` === `${b.pairs}`;
  }
  return false;
}
