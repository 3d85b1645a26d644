import type { Bounds } from '../../model/bounds.ts';

/** What an empty view shows: a sketching area of twelve by twelve modules. */
export const DEFAULT_BOX: Bounds = { min: [-6, -6, -1], max: [6, 6, 5] };

export function prefersReducedMotion(): boolean {
  return globalThis.matchMedia?.('(prefers-reduced-motion: reduce)').matches ?? false;
}
