import { effect, type ReadonlySignal, type Signal, signal } from '@preact/signals';
import type { SketchDocument } from '../model/sketch.ts';
import type { LibraryEntry, SketchLibrary, TabEvent } from '../state/library.ts';
import type { SearchSettings } from '../state/search-settings.ts';
import type { KeptState, KeptStep } from '../state/sketch-records.ts';
import type { WriterState } from '../state/sketch-writer.ts';
import type { SketchStore } from '../state/store.ts';

interface ShelfOptions {
  readonly store: SketchStore;
  /** What the sketch on the page is searched with, should it have brought that. */
  readonly settings: Signal<SearchSettings | null>;
  /** Puts on the page what another tab has made of the sketch that is open. */
  readonly onFollowed: (kept: KeptState) => void;
  readonly onEvent: (event: Exclude<TabEvent, 'changed'>) => void;
}

/** Keeps what is on the page in the library, and decides when it becomes a sketch of its own. */
export class SketchShelf {
  readonly #options: ShelfOptions;
  readonly #state = signal<WriterState | null>(null);
  #library: SketchLibrary | null = null;
  /** The sketch as it came, by a file, a link or an example; null for one of the library. */
  #came: SketchDocument | null = null;
  /** As they were written last. */
  #settings: SearchSettings | null = null;
  /** Another tab has a newer revision, which waits for a gesture's end or for this tab to be seen. */
  #behind = false;

  /** Whether all that was drawn is safe; null before anything is kept. */
  readonly state: ReadonlySignal<WriterState | null> = this.#state;

  constructor(options: ShelfOptions) {
    this.#options = options;
    options.store.listen((step) => this.#record([step]));
  }

  /** @returns the sketch of the last visit, or null on a first one. */
  async begin(library: SketchLibrary): Promise<KeptState | null> {
    const saved = await library.begin();
    this.#library = library;
    this.#take(saved?.settings ?? null);
    return saved;
  }

  /** Keeps what is on the page, and every change from now on; follows what other tabs make of it. */
  keepEdits(): void {
    const { store, settings } = this.#options;
    if (this.#library?.known === false) {
      this.#library.record([], this.#now());
    }
    this.noteState();
    effect(() => {
      if (settings.value !== this.#settings) {
        this.#record([]);
      }
    });
    effect(() => {
      store.sketch.value;
      this.#follow();
    });
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') {
        this.#library?.flush();
      } else {
        this.#behind = true;
        this.#follow();
      }
    });
    window.addEventListener('pagehide', () => this.#library?.flush());
    window.addEventListener('beforeunload', (event) => {
      if (this.#library?.state === 'refused') {
        event.preventDefault();
      }
    });
  }

  /** The library's state may have changed. */
  noteState(): void {
    this.#state.value = this.#library?.state ?? null;
  }

  /** Something happened to the open sketch in another tab. */
  noteEvent(event: TabEvent): void {
    this.#behind = event === 'changed';
    if (event === 'changed') {
      this.#follow();
    } else {
      this.#options.onEvent(event);
    }
  }

  /**
   * Another sketch is about to take the page. What was drawn stays in the library as it is; what only
   * came to be looked at, and nothing at all, gives its place away.
   */
  leave(coming: SketchDocument, settings: SearchSettings | null = null): void {
    const sketch = this.#options.store.sketch.value;
    const given = this.#settings;
    if (sketch.lines.length > 0 && sketch !== this.#came) {
      this.#library?.startNew();
      this.#take(settings);
    } else {
      this.#take(settings);
      // They are written with the step that brings the sketch.
      this.#settings = given;
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
  async open(id: string): Promise<KeptState | null> {
    const saved = (await this.#library?.open(id)) ?? null;
    if (saved) {
      this.#came = null;
      this.#behind = false;
      this.#take(saved.settings);
    }
    return saved;
  }

  async duplicate(id: string, name: (original: string) => string): Promise<void> {
    await this.#library?.duplicate(id, name);
  }

  /** @returns false when another tab has changed the sketch since it was listed. */
  async remove(id: string): Promise<boolean> {
    return (await this.#library?.remove(id)) ?? true;
  }

  /** Settles when everything is written, or has failed. */
  async kept(): Promise<void> {
    await this.#library?.flushed();
  }

  #now(): KeptState {
    return { ...this.#options.store.save(), settings: this.#options.settings.peek() };
  }

  #record(steps: readonly KeptStep[]): void {
    const after = this.#now();
    const { settings } = after;
    const more: readonly KeptStep[] =
      settings === this.#settings ? [] : [{ kind: 'settings', settings }];
    this.#settings = settings;
    this.#library?.record([...steps, ...more], after);
  }

  /** Settings that come with a sketch: nothing that would have to be written. */
  #take(settings: SearchSettings | null): void {
    this.#settings = settings;
    this.#options.settings.value = settings;
  }

  #follow(): void {
    const { store, onFollowed } = this.#options;
    if (!this.#behind || store.underWay || document.visibilityState === 'hidden') {
      return;
    }
    this.#behind = false;
    const show = (kept: KeptState) => {
      this.#behind = store.underWay;
      if (!this.#behind) {
        this.#came = null;
        this.#take(kept.settings);
        onFollowed(kept);
      }
      return !this.#behind;
    };
    // What cannot be read is not followed; a write would find out.
    this.#library?.follow(show).catch(() => undefined);
  }
}
