import type { Page } from './page.ts';

/** Whether a model is being searched for, or will be in a moment without anybody's asking. */
export function modelComing(
  page: Pick<Page, 'solve' | 'shown' | 'preferences' | 'small' | 'store'>,
): boolean {
  const { phase } = page.solve.value;
  const bySelf = page.preferences.value.autoSolve && page.small.value;
  const drawn = page.store.sketch.value.lines.length > 0;
  return phase === 'solving' || (phase === 'idle' && bySelf && drawn && page.shown.value === null);
}
