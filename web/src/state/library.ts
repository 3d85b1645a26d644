import type { SketchDocument } from '../model/sketch.ts';
import { Autosaver, type KeptSketch, loadSaved } from './autosave.ts';
import type { KeyValueStore } from './storage.ts';
import type { SavedSketch } from './store.ts';

const LIST = 'sketch/list';
/** The sketch of the time when there was only one. */
const FIRST_ID = 'current';
/** In the storage of this tab: which sketch it shows, so that two tabs show two sketches. */
const TAB_KEY = 'liftarm/open-sketch';

/** One of the sketches that this browser keeps. */
export interface LibraryEntry {
  readonly id: string;
  readonly sketch: SketchDocument;
  /** Milliseconds since 1970; 0 when not known. */
  readonly changed: number;
}

export interface LibraryOptions {
  readonly store: KeyValueStore;
  /** What this tab keeps for itself; null where the browser keeps nothing. */
  readonly tab: Pick<Storage, 'getItem' | 'setItem'> | null;
  /** Makes a name that no other sketch has. */
  readonly newId: () => string;
  readonly onFailure: (error: unknown) => void;
}

/** All sketches of this browser, each kept under its own key; one of them is open. */
export class SketchLibrary {
  readonly #options: LibraryOptions;
  readonly #saver: Autosaver;
  #ids: readonly string[] = [];
  #open: string = FIRST_ID;

  constructor(options: LibraryOptions) {
    this.#options = options;
    this.#saver = new Autosaver(options.store, options.onFailure);
  }

  /** The sketch that is open. */
  get openId(): string {
    return this.#open;
  }

  /** Whether the newest state of a sketch is not safe yet. */
  get unsaved(): boolean {
    return this.#saver.unsaved;
  }

  /** Finds what was open in this tab, else what was changed last. @returns null on a first visit. */
  async begin(): Promise<SavedSketch | null> {
    this.#ids = await this.#readIds();
    const wanted = this.#options.tab?.getItem(TAB_KEY) ?? '';
    const order = [...new Set([wanted, ...this.#ids].filter((id) => this.#ids.includes(id)))];
    for (const id of order) {
      const saved = await this.#load(id);
      if (saved) {
        this.#use(id);
        return saved;
      }
    }
    this.startNew();
    return null;
  }

  /** Keeps the open sketch; returns at once. One without lines that was never kept is not. */
  save(saved: SavedSketch): void {
    const known = this.#ids.includes(this.#open);
    if (!known && saved.sketch.lines.length === 0 && saved.history.past.length === 0) {
      return;
    }
    if (this.#ids[0] !== this.#open) {
      this.#writeIds([this.#open, ...this.#ids.filter((id) => id !== this.#open)]);
    }
    this.#saver.save(keyOf(this.#open), saved);
  }

  /** What is saved from now on is another sketch; the one that was open stays as it is. */
  startNew(): void {
    this.#use(this.#options.newId());
  }

  /** Opens a kept sketch. @returns null when it is not there any more. */
  async open(id: string): Promise<SavedSketch | null> {
    await this.#saver.flushed();
    const saved = await this.#load(id);
    if (saved) {
      this.#use(id);
    }
    return saved;
  }

  /** Keeps a copy beside the original. */
  async duplicate(id: string, name: (original: string) => string): Promise<void> {
    await this.#saver.flushed();
    const saved = await this.#load(id);
    if (saved) {
      const sketch = { ...saved.sketch, name: name(saved.sketch.name ?? '') };
      const copy = this.#options.newId();
      this.#writeIds([copy, ...this.#ids]);
      this.#saver.save(keyOf(copy), { sketch, history: { past: [], future: [] } });
      await this.#saver.flushed();
    }
  }

  /** Forgets a sketch for good. */
  async remove(id: string): Promise<void> {
    await this.#saver.flushed();
    this.#writeIds(this.#ids.filter((each) => each !== id));
    await this.#options.store.delete(keyOf(id)).catch(this.#options.onFailure);
  }

  /** All kept sketches, the one changed last first. */
  async list(): Promise<LibraryEntry[]> {
    await this.#saver.flushed();
    const entries = await Promise.all(
      this.#ids.map(async (id) => {
        const saved = await this.#load(id);
        return saved ? [{ id, sketch: saved.sketch, changed: saved.changed }] : [];
      }),
    );
    return entries.flat();
  }

  /** Settles when everything given so far is written, or has failed. */
  flushed(): Promise<void> {
    return this.#saver.flushed();
  }

  #use(id: string): void {
    this.#open = id;
    try {
      this.#options.tab?.setItem(TAB_KEY, id);
    } catch {
      // Full or forbidden: after a reload the newest sketch is shown.
    }
  }

  #load(id: string): Promise<KeptSketch | null> {
    return loadSaved(this.#options.store, keyOf(id)).catch(() => null);
  }

  async #readIds(): Promise<readonly string[]> {
    const value = await this.#options.store.get(LIST).catch(() => null);
    const ids = Array.isArray(value) ? value.filter((id) => typeof id === 'string') : [FIRST_ID];
    return [...new Set(ids)];
  }

  #writeIds(ids: readonly string[]): void {
    this.#ids = ids;
    this.#options.store.set(LIST, ids).catch(this.#options.onFailure);
  }
}

function keyOf(id: string): string {
  return `sketch/${id}`;
}
