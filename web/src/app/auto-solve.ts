import { effect } from '@preact/signals';
import type { PageState } from './page-state.ts';
import { isSmall, searchText } from './page-state.ts';

/** A pause in the drawing after which a small sketch is solved. */
const PAUSE_MS = 500;

/**
 * Starts a search a moment after each edit of a small sketch. A search for an older sketch is given up.
 * @returns what stops it.
 */
export function solveAfterEdits(
  state: PageState,
  generate: () => void,
  drop: () => void,
): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let asked: string | null = null;
  const stop = effect(() => {
    const sketch = state.store.sketch.value;
    const { autoSolve } = state.preferences.value;
    clearTimeout(timer);
    const wanted = searchText(sketch);
    const shown = state.shown.peek();
    const known = shown?.report && shown.sketch ? searchText(shown.sketch) === wanted : false;
    if (wanted === asked || known) {
      return;
    }
    if (asked !== null && state.solve.peek().phase === 'solving') {
      drop();
    }
    asked = null;
    if (autoSolve && sketch.lines.length > 0 && isSmall(sketch)) {
      timer = setTimeout(() => {
        asked = wanted;
        generate();
      }, PAUSE_MS);
    }
  });
  return () => {
    clearTimeout(timer);
    stop();
  };
}
