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

/** Triangles of all bricks together that a laptop draws at its full frame rate. */
export const TRIANGLE_BUDGET = 1_900_000;

const FROM_FINE_TO_COARSE: readonly DetailName[] = ['ultra', 'high', 'medium', 'low'];

/** Pixels per module from which a level shows more than the next coarser one. */
const WORTH_IT: Readonly<Record<DetailName, number>> = { ultra: 110, high: 22, medium: 9, low: 0 };

/**
 * Level of detail for all bricks: the finest that can be seen at their size and that stays within
 * the budget of triangles.
 * @param pixelsPerModule CSS pixels that one module takes at what is looked at.
 * @param trianglesAt triangles of the whole model at a level; asked from fine to coarse.
 */
export function chooseDetail(
  pixelsPerModule: number,
  trianglesAt: (detail: DetailName) => number,
): DetailChoice {
  const detail =
    FROM_FINE_TO_COARSE.find(
      (name) => pixelsPerModule >= WORTH_IT[name] && trianglesAt(name) <= TRIANGLE_BUDGET,
    ) ?? 'low';
  return { detail, lineOpacity: edgeOpacity(pixelsPerModule) };
}
