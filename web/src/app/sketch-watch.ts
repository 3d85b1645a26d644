import { effect } from '@preact/signals';
import { readFoundSymmetries } from '../model/found-symmetries.ts';
import { lineLength, type SketchDocument } from '../model/sketch.ts';
import { readSketchNotes } from '../model/sketch-notes.ts';
import type { SolverClient } from '../solver/worker-client.ts';
import { writeSketch } from '../state/read-sketch.ts';
import { findTwins } from '../state/sketch-faults.ts';
import { settingsOf } from '../ui/solve-settings.ts';
import type { PageState } from './page-state.ts';

/** A pause in the drawing after which the sketch is looked through. */
const PAUSE_MS = 200;
/** Larger sketches are not looked through: it would hold up the pointer. */
const LARGEST = { lines: 1200, length: 8000 } as const;

/** Finds faults and symmetries of the sketch a moment after each edit. @returns what stops it. */
export function watchSketch(state: PageState, solver: Pick<SolverClient, 'ask'>): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let looking = new AbortController();
  const stop = effect(() => {
    const sketch = state.store.sketch.value;
    clearTimeout(timer);
    looking.abort();
    looking = new AbortController();
    const { signal } = looking;
    timer = setTimeout(() => {
      const looked = isSmallEnough(sketch);
      state.faults.value = looked ? findTwins(sketch) : [];
      state.foundSymmetries.value = [];
      if (looked && sketch.lines.length > 0) {
        void lookThrough(state, solver, { sketch, signal });
      }
      if (looked && sketch.joints) {
        void askForJoints(state, solver, { sketch, signal });
      } else {
        state.jointRefusal.value = null;
      }
    }, PAUSE_MS);
  });
  return () => {
    clearTimeout(timer);
    looking.abort();
    stop();
  };
}

async function lookThrough(
  state: PageState,
  solver: Pick<SolverClient, 'ask'>,
  { sketch, signal }: { readonly sketch: SketchDocument; readonly signal: AbortSignal },
): Promise<void> {
  const sketchJson = JSON.stringify(sketch);
  // Without an answer, as when the worker died, none are offered; the next edit asks again.
  const reply = await solver.ask({ about: 'symmetries', sketchJson }, signal).catch(() => null);
  // What came in too late is about a sketch that is gone.
  if (reply?.outcome === 'ok' && state.store.sketch.value === sketch) {
    state.faults.value = [...findTwins(sketch), ...readSketchNotes(reply.text)];
    // One line, or two in a row, are symmetric in many ways that nobody means.
    state.foundSymmetries.value = sketch.lines.length > 2 ? readFoundSymmetries(reply.text) : [];
  }
}

/** Joints that cannot be had together are said at once, not by a search that fails. */
async function askForJoints(
  state: PageState,
  solver: Pick<SolverClient, 'ask'>,
  { sketch, signal }: { readonly sketch: SketchDocument; readonly signal: AbortSignal },
): Promise<void> {
  const settings = settingsOf(state.preferences.peek());
  const question = { about: 'opens', sketchJson: writeSketch(sketch), settings } as const;
  const reply = await solver.ask(question, signal).catch(() => null);
  if (reply && state.store.sketch.value === sketch) {
    const message = reply.outcome === 'refused' ? reply.message : '';
    state.jointRefusal.value = message.startsWith('joints[') ? message : null;
  }
}

function isSmallEnough(sketch: SketchDocument): boolean {
  const length = sketch.lines.reduce((sum, line) => sum + lineLength(line), 0);
  return sketch.lines.length <= LARGEST.lines && length <= LARGEST.length;
}
