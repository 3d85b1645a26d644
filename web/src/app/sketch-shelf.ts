import { effect } from '@preact/signals';
import type { SketchDocument } from '../model/sketch.ts';
import type { LibraryEntry, SketchLibrary } from '../state/library.ts';
import type { SavedSketch, SketchStore } from '../state/store.ts';

/** Keeps what is on the page in the library, and decides when it becomes a sketch of its own. */
export class SketchShelf {
  readonly #store: SketchStore;
  #library: SketchLibrary | null = null;
  /** The sketch as it came, by a file, a link or an example; null for one of the library. */
  #came: SketchDocument | null = null;

  constructor(store: SketchStore) {
    this.#store = store;
  }

  /** @returns the sketch of the last visit, or null on a first one. */
  async begin(library: SketchLibrary): Promise<SavedSketch | null> {
    this.#library = library;
    return library.begin();
  }

  /** Keeps every edit from now on. */
  keepEdits(): void {
    effect(() => {
      // The history changes with every captured edit and with nothing else.
      this.#store.history.value;
      this.#library?.save(this.#store.save());
    });
    window.addEventListener('beforeunload', (event) => {
      if (this.#library?.unsaved) {
        event.preventDefault();
      }
    });
  }

  /**
   * Another sketch is about to take the page. What was drawn stays in the library as it is; what only
   * came to be looked at, and nothing at all, gives its place away.
   */
  leave(coming: SketchDocument): void {
    const { lines } = this.#store.sketch.value;
    if (lines.length > 0 && this.#store.sketch.value !== this.#came) {
      this.#library?.startNew();
    }
    this.#came = coming;
  }

  list(): Promise<LibraryEntry[]> {
    return this.#library?.list() ?? Promise.resolve([]);
  }

  get openId(): string {
    return this.#library?.openId ?? '';
  }

  /** Loads a kept sketch. @returns null when it is not there any more. */
  async open(id: string): Promise<SavedSketch | null> {
    const saved = (await this.#library?.open(id)) ?? null;
    if (saved) {
      this.#came = null;
    }
    return saved;
  }

  async duplicate(id: string, name: (original: string) => string): Promise<void> {
    await this.#library?.duplicate(id, name);
  }

  async remove(id: string): Promise<void> {
    await this.#library?.remove(id);
  }

  /** Settles when everything is written, or has failed. */
  async kept(): Promise<void> {
    await this.#library?.flushed();
  }
}
