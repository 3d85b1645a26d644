import { effect } from '@preact/signals';
import type { SketchDocument } from '../model/sketch.ts';
import type { PageState } from './page-state.ts';
import { isSmall, searchText } from './page-state.ts';

/** A pause in the drawing after which a small sketch is solved. */
const PAUSE_MS = 500;

/** What starts and gives up a search. */
export interface Search {
  generate(): void;
  drop(): void;
  sketchUnderWay(): SketchDocument | null;
}

/**
 * Starts a search a moment after each edit of a small sketch. A search that was started so is given up
 * when the sketch changes; one that a person asked for goes on.
 * @returns what stops it.
 */
export function solveAfterEdits(state: PageState, search: Search): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let asked: string | null = null;
  const underWay = () => {
    const sketch = search.sketchUnderWay();
    return sketch ? searchText(sketch) : null;
  };
  const stop = effect(() => {
    const sketch = state.store.sketch.value;
    const { autoSolve } = state.preferences.value;
    clearTimeout(timer);
    const wanted = searchText(sketch);
    const known = () => {
      const shown = state.shown.peek();
      return shown?.report && shown.sketch ? searchText(shown.sketch) === wanted : false;
    };
    if (wanted === asked || known()) {
      return;
    }
    if (asked !== null && underWay() === asked) {
      search.drop();
    }
    asked = null;
    if (autoSolve && sketch.lines.length > 0 && isSmall(sketch)) {
      timer = setTimeout(() => {
        // A search that was asked for meanwhile may be under way, or over.
        if (underWay() !== wanted && !known()) {
          asked = wanted;
          search.generate();
        }
      }, PAUSE_MS);
    }
  });
  return () => {
    clearTimeout(timer);
    stop();
  };
}
