import { add, length, scale, subtract, type Vec3 } from '../geometry/vec.ts';
import type { Addition } from './assembly-plan.ts';

/** How far a part is from its place at a moment of its flight. @param t 0 (start) to 1 (in place). */
export function flightOffset(addition: Addition, t: number): Vec3 {
  const moves = [...addition.via, addition.travel];
  const lengths = moves.map((move) => Math.max(1e-6, length(move)));
  const total = lengths.reduce((sum, value) => sum + value, 0);
  let left = (1 - Math.min(1, Math.max(0, t))) * total;
  let offset: Vec3 = [0, 0, 0];
  for (let i = moves.length - 1; i >= 0 && left > 0; i--) {
    const size = lengths[i] ?? 1;
    const share = Math.min(1, left / size);
    offset = subtract(offset, scale(moves[i] ?? [0, 0, 0], share));
    left -= size;
  }
  return offset;
}

/** Slow at both ends. */
export function eased(t: number): number {
  return t * t * (3 - 2 * t);
}

/**
 * Where the parts of a film stand: how far each is from its place. A part that is built into a
 * subassembly flies twice, into it and with it. Parts left out are not there yet.
 * @param moment additions done so far; 2.5 is half way through the third.
 */
export function filmOffsets(
  sequence: readonly Addition[],
  moment: number,
): ReadonlyMap<number, Vec3> {
  const offsets = new Map<number, Vec3>();
  const started = new Set<number>();
  sequence.forEach((addition, i) => {
    const t = moment - i;
    const offset = flightOffset(addition, eased(Math.min(1, Math.max(0, t))));
    for (const part of addition.parts) {
      if (t > 0 || started.has(part)) {
        started.add(part);
        offsets.set(part, add(offsets.get(part) ?? [0, 0, 0], offset));
      }
    }
  });
  return offsets;
}
