import { effect } from '@preact/signals';
import { findMirrors } from '../geometry/mirrors.ts';
import { lineLength, type SketchDocument } from '../model/sketch.ts';
import { findFaults } from '../state/sketch-faults.ts';
import type { PageState } from './page-state.ts';

/** A pause in the drawing after which the sketch is looked through. */
const PAUSE_MS = 200;
/** Larger sketches are not looked through: it would hold up the pointer. */
const LARGEST = { lines: 1200, length: 8000 } as const;

/** Finds faults and symmetries of the sketch a moment after each edit. @returns what stops it. */
export function watchSketch(state: PageState): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const stop = effect(() => {
    const sketch = state.store.sketch.value;
    clearTimeout(timer);
    timer = setTimeout(() => {
      const looked = isSmallEnough(sketch);
      state.faults.value = looked ? findFaults(sketch) : [];
      // One line, or two in a row, are symmetric in many ways that nobody means.
      const wanted = looked && sketch.lines.length > 2;
      state.mirrors.value = wanted ? findMirrors(sketch.lines) : [];
    }, PAUSE_MS);
  });
  return () => {
    clearTimeout(timer);
    stop();
  };
}

function isSmallEnough(sketch: SketchDocument): boolean {
  const length = sketch.lines.reduce((sum, line) => sum + lineLength(line), 0);
  return sketch.lines.length <= LARGEST.lines && length <= LARGEST.length;
}
