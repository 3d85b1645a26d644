import type { DetailName } from './bricks/detail.ts';

/** What is drawn of the bricks at a given size. */
export interface DetailChoice {
  readonly detail: DetailName;
  /** Opacity of the drawn edges: less as bricks grow small, 0 where they would only darken them. */
  readonly lineOpacity: number;
}

/** Pixels per module at which edges vanish and at which they have their full strength. */
const EDGES = { none: 4, full: 34, strength: 0.85 } as const;

function edgeOpacity(pixelsPerModule: number): number {
  const share = (pixelsPerModule - EDGES.none) / (EDGES.full - EDGES.none);
  return EDGES.strength * Math.sqrt(Math.min(1, Math.max(0, share)));
}

/**
 * Level of detail for all bricks: by their size on screen, and coarser for very many of them.
 * @param partCount bricks in the model.
 * @param pixelsPerModule CSS pixels that one module takes at what is looked at.
 */
export function chooseDetail(partCount: number, pixelsPerModule: number): DetailChoice {
  const lineOpacity = edgeOpacity(pixelsPerModule);
  if (pixelsPerModule >= 110 && partCount <= 400) {
    return { detail: 'ultra', lineOpacity };
  }
  if (pixelsPerModule >= 22 && partCount <= 1200) {
    return { detail: 'high', lineOpacity };
  }
  if (pixelsPerModule >= 9 && partCount <= 3000) {
    return { detail: 'medium', lineOpacity };
  }
  return { detail: 'low', lineOpacity };
}
