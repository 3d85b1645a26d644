import { effect } from '@preact/signals';
import { partsText, settingsOf } from '../ui/solve-settings.ts';
import type { PageState } from './page-state.ts';
import { isSmall, searchText } from './page-state.ts';
import type { Wish } from './solve-run.ts';

/** A pause in the drawing after which a small sketch is solved. */
const PAUSE_MS = 500;

/** What starts and gives up a search. */
export interface Search {
  generate(): void;
  drop(): void;
  wishUnderWay(): Wish | null;
}

/**
 * Starts a search a moment after each edit of a small sketch, and after each change of the parts that there are.
 * A search that was started so is given up when either changes; one that a person asked for goes on.
 * @returns what stops it.
 */
export function solveAfterEdits(state: PageState, search: Search): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let asked: string | null = null;
  let seen = '';
  const underWay = () => {
    const wish = search.wishUnderWay();
    return wish ? textOf(wish) : null;
  };
  const stop = effect(() => {
    const sketch = state.store.sketch.value;
    const { autoSolve } = state.preferences.value;
    const parts = partsText(settingsOf(state.preferences.value));
    const wanted = textOf({ sketch, parts });
    const now = `${autoSolve} ${wanted}`;
    if (now === seen) {
      // How the picture is to look is no matter of a search, and the model of a file stays over the drawing before.
      return;
    }
    seen = now;
    clearTimeout(timer);
    const known = () => {
      const shown = state.shown.peek();
      // What a file held was made with parts of its own.
      return shown?.report && shown.sketch
        ? textOf({ sketch: shown.sketch, parts: shown.parts ?? parts }) === wanted
        : false;
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

/** Equal texts, equal searches. */
function textOf({ sketch, parts }: Wish): string {
  return `${searchText(sketch)} ${parts}`;
}
