import { add, dot, type Mat3, scale, subtract, type Vec3 } from '../geometry/vec.ts';
import type { PlacedPart } from '../model/model.ts';
import type { BrickLibrary } from './bricks/brick-library.ts';
import type { BrickMesh } from './bricks/mesh-builder.ts';
import type { PartPick, Ray } from './view-types.ts';

/** What picking needs to know about the parts as drawn. */
export interface PickContext {
  readonly library: BrickLibrary;
  /** Added to a part's position. */
  readonly shift: (index: number) => Vec3;
  readonly isPickable: (index: number) => boolean;
}

/** The nearest part whose coarse surface the ray meets; the ray may pass through holes. */
export function pickPart(
  ray: Ray,
  parts: readonly PlacedPart[],
  context: PickContext,
): PartPick | null {
  let best: PartPick | null = null;
  for (const { index, local, entry, part } of candidates(ray, parts, context)) {
    if (best && entry > best.distance) {
      break;
    }
    const mesh = context.library.get(part, 'low')?.mesh;
    const distance = mesh ? rayMeetsMesh(local, mesh) : null;
    if (distance !== null && (!best || distance < best.distance)) {
      best = { index, distance, point: add(ray.origin, scale(ray.direction, distance)) };
    }
  }
  return best;
}

interface Candidate {
  readonly index: number;
  readonly part: string;
  /** The ray in the part's own frame. */
  readonly local: Ray;
  /** Where it enters the part's box, modules along the ray. */
  readonly entry: number;
}

/** Parts whose boxes the ray enters, nearest first. */
function candidates(ray: Ray, parts: readonly PlacedPart[], context: PickContext): Candidate[] {
  const found: Candidate[] = [];
  parts.forEach((placed, index) => {
    const part = context.library.catalogue.find(placed.part);
    if (!part || !context.isPickable(index)) {
      return;
    }
    const local = toPartFrame(ray, placed, context.shift(index));
    const entry = rayEntersBox(local, part.boundsMin, part.boundsMax);
    if (entry !== null) {
      found.push({ index, part: placed.part, local, entry });
    }
  });
  return found.sort((a, b) => a.entry - b.entry);
}

function toPartFrame(ray: Ray, placed: PlacedPart, shift: Vec3): Ray {
  const origin = subtract(ray.origin, add(placed.position, shift));
  return {
    origin: rotateBack(placed.rotation, origin),
    direction: rotateBack(placed.rotation, ray.direction),
  };
}

/** The transposed rotation times v. */
function rotateBack(m: Mat3, v: Vec3): Vec3 {
  return [
    m[0] * v[0] + m[3] * v[1] + m[6] * v[2],
    m[1] * v[0] + m[4] * v[1] + m[7] * v[2],
    m[2] * v[0] + m[5] * v[1] + m[8] * v[2],
  ];
}

/** Distance at which the ray enters the box, 0 from inside; null when it misses. */
export function rayEntersBox(ray: Ray, min: Vec3, max: Vec3): number | null {
  let enter = 0;
  let leave = Infinity;
  for (const i of [0, 1, 2] as const) {
    const speed = ray.direction[i];
    const low = min[i] - ray.origin[i];
    const high = max[i] - ray.origin[i];
    if (Math.abs(speed) < 1e-12) {
      if (low > 0 || high < 0) {
        return null;
      }
      continue;
    }
    const t0 = Math.min(low / speed, high / speed);
    const t1 = Math.max(low / speed, high / speed);
    enter = Math.max(enter, t0);
    leave = Math.min(leave, t1);
  }
  return enter <= leave ? enter : null;
}

/** Distance to the first triangle that the ray meets from its front, or null. */
function rayMeetsMesh(ray: Ray, mesh: BrickMesh): number | null {
  let best = Infinity;
  const { indices, positions } = mesh;
  const at = (corner: number): Vec3 => {
    const i = (indices[corner] ?? 0) * 3;
    return [positions[i] ?? 0, positions[i + 1] ?? 0, positions[i + 2] ?? 0];
  };
  for (let i = 0; i < indices.length; i += 3) {
    const t = rayMeetsTriangle(ray, [at(i), at(i + 1), at(i + 2)]);
    if (t !== null && t < best) {
      best = t;
    }
  }
  return best === Infinity ? null : best;
}

/** Moeller and Trumbore's test (1997), front faces only. */
export function rayMeetsTriangle(ray: Ray, [a, b, c]: readonly [Vec3, Vec3, Vec3]): number | null {
  const ab = subtract(b, a);
  const ac = subtract(c, a);
  const d = ray.direction;
  const p: Vec3 = [
    d[1] * ac[2] - d[2] * ac[1],
    d[2] * ac[0] - d[0] * ac[2],
    d[0] * ac[1] - d[1] * ac[0],
  ];
  const determinant = dot(ab, p);
  if (determinant < 1e-12) {
    return null;
  }
  const s = subtract(ray.origin, a);
  const u = dot(s, p);
  if (u < 0 || u > determinant) {
    return null;
  }
  const q: Vec3 = [
    s[1] * ab[2] - s[2] * ab[1],
    s[2] * ab[0] - s[0] * ab[2],
    s[0] * ab[1] - s[1] * ab[0],
  ];
  const v = dot(d, q);
  if (v < 0 || u + v > determinant) {
    return null;
  }
  const t = dot(ac, q) / determinant;
  return t > 0 ? t : null;
}
