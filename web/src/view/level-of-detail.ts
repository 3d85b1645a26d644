import type { DetailName } from './bricks/detail.ts';

/** What is drawn of the bricks at a given size. */
export interface DetailChoice {
  readonly detail: DetailName;
  /** The drawn edges; left out where they would only darken the picture. */
  readonly lines: boolean;
}

/**
 * Level of detail for all bricks: by their size on screen, and coarser for very many of them.
 * @param partCount bricks in the model.
 * @param pixelsPerModule CSS pixels that one module takes at what is looked at.
 */
export function chooseDetail(partCount: number, pixelsPerModule: number): DetailChoice {
  const lines = pixelsPerModule >= 5;
  if (pixelsPerModule >= 110 && partCount <= 400) {
    return { detail: 'ultra', lines };
  }
  if (pixelsPerModule >= 22 && partCount <= 1200) {
    return { detail: 'high', lines };
  }
  if (pixelsPerModule >= 9 && partCount <= 3000) {
    return { detail: 'medium', lines };
  }
  return { detail: 'low', lines };
}
