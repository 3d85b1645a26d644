import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import { emptySketch, type SketchDocument, type SketchLine } from '../model/sketch.ts';
import { applyKept, diffSketch, invertDelta, isEmptyDelta, type SketchDelta } from './delta.ts';
import { EMPTY_HISTORY, type History, pushEntry, stepBack, stepForward } from './history.ts';
import { readSketchValue } from './read-sketch.ts';

/** How a change enters the history: at once, or with the next one (a drag under way). */
export type Capture = 'now' | 'later';

/** One move through the history; `delta` is what it does to the sketch. */
export type Step =
  | { readonly kind: 'push'; readonly label: string; readonly delta: SketchDelta }
  | { readonly kind: 'undo' | 'redo'; readonly delta: SketchDelta };

/** Everything of the sketch that survives a reload. */
export interface SavedSketch {
  readonly sketch: SketchDocument;
  readonly history: History;
}

/** What a step of a kept history leads to: where that is damaged it may be no sketch, and must not come on the page. */
function readable(sketch: SketchDocument | null): SketchDocument | null {
  return sketch && readSketchValue(sketch).ok ? sketch : null;
}

/** The sketch on the page and its history. The only place where either changes. */
export class SketchStore {
  readonly #sketch = signal<SketchDocument>(emptySketch());
  readonly #history = signal<History>(EMPTY_HISTORY);
  readonly #selection = signal<ReadonlySet<number>>(new Set());
  /** The sketch as the newest history entry left it; differs while a gesture is under way. */
  #captured: SketchDocument = this.#sketch.value;
  #onStep: (step: Step) => void = () => undefined;

  readonly sketch: ReadonlySignal<SketchDocument> = this.#sketch;
  readonly history: ReadonlySignal<History> = this.#history;
  /** Indices of the selected lines. */
  readonly selection: ReadonlySignal<ReadonlySet<number>> = this.#selection;
  readonly canUndo = computed(() => this.#history.value.past.length > 0);
  readonly canRedo = computed(() => this.#history.value.future.length > 0);

  /** Tells one listener of every step, as soon as it is done; restore() is none. */
  listen(onStep: (step: Step) => void): void {
    this.#onStep = onStep;
  }

  /** Whether there is more on the page than the history has: a gesture is under way. */
  get underWay(): boolean {
    return this.#sketch.peek() !== this.#captured;
  }

  /** Puts `next` in place of the sketch; `label` names the step for undo. */
  commit(label: string, next: SketchDocument, capture: Capture = 'now'): void {
    batch(() => {
      if (next !== this.#sketch.value) {
        this.#sketch.value = next;
        this.#dropStaleSelection();
      }
      if (capture === 'later') {
        return;
      }
      const delta = diffSketch(this.#captured, next);
      this.#captured = next;
      if (!isEmptyDelta(delta)) {
        this.#history.value = pushEntry(this.#history.value, { label, delta });
        this.#onStep({ kind: 'push', label, delta });
      }
    });
  }

  /** Drops what 'later' commits did since the last captured step. */
  rollBack(): void {
    if (this.#sketch.value !== this.#captured) {
      this.#sketch.value = this.#captured;
    }
  }

  /** @returns the label of what was undone, or null at the beginning, and where the history is damaged: it ends there. */
  undo(): string | null {
    this.rollBack();
    const step = stepBack(this.#history.value);
    if (!step) {
      return null;
    }
    const delta = invertDelta(step.entry.delta);
    const before = readable(applyKept(this.#captured, delta));
    if (!before) {
      this.#history.value = { ...this.#history.value, past: [] };
      return null;
    }
    this.#step(before, step.history);
    this.#onStep({ kind: 'undo', delta });
    return step.entry.label;
  }

  /** @returns the label of what was done again, or null at the end. */
  redo(): string | null {
    this.rollBack();
    const step = stepForward(this.#history.value);
    if (!step) {
      return null;
    }
    const { delta } = step.entry;
    const after = readable(applyKept(this.#captured, delta));
    if (!after) {
      this.#history.value = { ...this.#history.value, future: [] };
      return null;
    }
    this.#step(after, step.history);
    this.#onStep({ kind: 'redo', delta });
    return step.entry.label;
  }

  select(indices: Iterable<number>): void {
    const count = this.#sketch.value.lines.length;
    this.#selection.value = new Set([...indices].filter((i) => i >= 0 && i < count));
  }

  /** What must be written to survive a reload. A gesture under way is not in it. */
  save(): SavedSketch {
    return { sketch: this.#captured, history: this.#history.value };
  }

  restore(saved: SavedSketch): void {
    this.#move(saved.sketch, saved.history);
  }

  /** One step of the history: what was selected stays so, as far as it is still there. */
  #step(sketch: SketchDocument, history: History): void {
    const kept = keptSelection(this.#captured, sketch, this.#selection.value);
    batch(() => {
      this.#move(sketch, history);
      this.select(kept);
    });
  }

  #move(sketch: SketchDocument, history: History): void {
    batch(() => {
      this.#captured = sketch;
      this.#sketch.value = sketch;
      this.#history.value = history;
      this.#selection.value = new Set();
    });
  }

  #dropStaleSelection(): void {
    const count = this.#sketch.value.lines.length;
    const selection = this.#selection.value;
    if ([...selection].some((i) => i >= count)) {
      this.#selection.value = new Set([...selection].filter((i) => i < count));
    }
  }
}

/** Where the selected lines are in another state of a sketch: in their places, or where lines came or went, by their ends. */
function keptSelection(
  before: SketchDocument,
  after: SketchDocument,
  selected: ReadonlySet<number>,
): number[] {
  if (before.lines.length === after.lines.length) {
    return [...selected];
  }
  const keyOf = ({ from, to }: SketchLine) => JSON.stringify([from, to]);
  const wanted = new Set(before.lines.filter((_, i) => selected.has(i)).map(keyOf));
  return [...after.lines.keys()].filter((i) => {
    const line = after.lines[i];
    return line !== undefined && wanted.has(keyOf(line));
  });
}
