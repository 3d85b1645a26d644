import type { SketchDocument } from '../model/sketch.ts';
import { leaveLastWords, writeLastWords } from './last-words.ts';
import { readSketchValue } from './read-sketch.ts';
import {
  deleteSketch,
  type Kept,
  type KeptState,
  type KeptStep,
  readHeads,
  readHistory,
  readKept,
  readRevision,
  writeFirst,
} from './sketch-records.ts';
import { SketchWriter, type Track, type WriterState } from './sketch-writer.ts';
import type { RecordStore, Writing } from './storage.ts';
import type { TabNews } from './tab-news.ts';

/** Keys of the time when each sketch was one value, and a list said which there are. */
const OLD_PREFIX = 'sketch/';
const OLD_LIST = 'sketch/list';
/** In the storage of this tab: which sketch it shows, so that two tabs show two sketches. */
const TAB_KEY = 'liftarm/open-sketch';

/** One of the sketches that this browser keeps. */
export interface LibraryEntry {
  readonly id: string;
  readonly sketch: SketchDocument;
  /** Milliseconds since 1970; 0 when not known. */
  readonly changed: number;
}

/** What happened to the open sketch without this tab. */
export type TabEvent =
  /** There is a newer revision: follow() shows it. */
  | 'changed'
  /** It was deleted. It stays on the page, and the next step keeps it again. */
  | 'removed'
  /** It was changed while it was changed here: what is on the page is a sketch of its own now. */
  | 'forked';

export interface LibraryOptions {
  readonly store: RecordStore;
  /** What this tab keeps for itself; null where the browser keeps nothing. */
  readonly tab: Pick<Storage, 'getItem' | 'setItem'> | null;
  readonly news: TabNews;
  /** Makes a name that no other sketch has. */
  readonly newId: () => string;
  readonly onFailure: (error: unknown) => void;
  readonly onEvent: (event: TabEvent) => void;
  /** Told whenever `state` may have changed. */
  readonly onState: () => void;
}

/** All sketches of this browser; one of them is open. Several tabs may be at it at once. */
export class SketchLibrary {
  readonly #options: LibraryOptions;
  readonly #writer: SketchWriter;
  /** The revision of each sketch that the last list showed. */
  readonly #listed = new Map<string, number>();
  #track: Track;

  constructor(options: LibraryOptions) {
    this.#options = options;
    const { store, newId, news, onFailure, onState } = options;
    this.#writer = new SketchWriter({
      store,
      newId,
      onFailure,
      onState,
      onWritten: (id, revision) => news.tell({ kind: 'written', id, revision }),
      onForked: (track) => this.#forked(track),
    });
    this.#track = this.#writer.track(newId(), { seen: 0, whole: true });
    news.listen((heard) => {
      if (heard.id !== this.#track.id) {
        return;
      }
      if (heard.kind === 'removed') {
        options.onEvent('removed');
      } else if (heard.revision !== this.#track.seen) {
        options.onEvent('changed');
      }
    });
  }

  /** The sketch that is open. */
  get openId(): string {
    return this.#track.id;
  }

  /** Whether the open sketch is kept, or will be in a moment. */
  get known(): boolean {
    return this.#track.seen > 0 || this.#track.waiting;
  }

  get state(): WriterState {
    return this.#writer.state;
  }

  /** Finds what was open in this tab, else what was changed last. @returns null on a first visit. */
  async begin(): Promise<KeptState | null> {
    const { store, tab } = this.#options;
    await this.#takeOver();
    await writeLastWords(tab, store).catch(this.#options.onFailure);
    const heads = await store.read(readHeads);
    this.#writer.notBefore(heads[0]?.changed ?? 0);
    const ids = heads.map(({ id }) => id);
    const wanted = tab?.getItem(TAB_KEY) ?? '';
    const order = ids.includes(wanted) ? [wanted, ...ids.filter((id) => id !== wanted)] : ids;
    for (const id of order) {
      const kept = await this.open(id);
      if (kept) {
        return kept;
      }
    }
    this.startNew();
    return null;
  }

  /**
   * Keeps steps of the open sketch; returns at once. One without lines that was never kept is not.
   * @param after the sketch after them.
   */
  record(steps: readonly KeptStep[], after: KeptState): void {
    if (this.known || after.sketch.lines.length > 0 || after.history.past.length > 0) {
      this.#writer.add(this.#track, steps, after);
    }
  }

  /** What is recorded from now on is another sketch; the one that was open stays as it is. */
  startNew(): void {
    this.#use(this.#options.newId(), { revision: 0, whole: true });
  }

  /** Opens a kept sketch. @returns null when it is not there any more. */
  async open(id: string): Promise<KeptState | null> {
    await this.#writer.flushed();
    const kept = await this.#read(id);
    if (kept) {
      this.#use(id, kept);
    }
    return kept;
  }

  /**
   * Reads what another tab has made of the open sketch.
   * @param show puts it on the page; returns false when that is not possible now.
   */
  async follow(show: (kept: KeptState) => boolean): Promise<void> {
    const track = this.#track;
    const isBusy = () => track !== this.#track || track.waiting || track.seen === 0;
    if (isBusy()) {
      return;
    }
    const newest = await this.#options.store.read((records) => readRevision(records, track.id));
    if (newest === track.seen) {
      return;
    }
    const kept = await this.#read(track.id);
    if (kept && !isBusy() && kept.revision !== track.seen && show(kept)) {
      this.#writer.adopt(track, kept);
    }
  }

  /** Keeps a copy beside the original. */
  async duplicate(id: string, name: (original: string) => string): Promise<void> {
    await this.#writer.flushed();
    const kept = await this.#read(id);
    if (kept) {
      const { settings } = kept;
      const sketch = { ...kept.sketch, name: name(kept.sketch.name ?? '') };
      const copy = { sketch, settings, history: { past: [], future: [] } };
      const made = { id: this.#options.newId(), changed: Date.now() };
      await this.#options.store
        .change(async (records) => writeFirst(records, made, copy))
        .catch(this.#options.onFailure);
    }
  }

  /**
   * Forgets a sketch for good.
   * @returns false when it is not what the last list showed: another tab has changed it since.
   */
  async remove(id: string): Promise<boolean> {
    const { store, news, onFailure } = this.#options;
    await this.#writer.flushed();
    const work = async (records: Writing) => {
      if ((await readRevision(records, id)) !== this.#listed.get(id)) {
        return false;
      }
      deleteSketch(records, id);
      return true;
    };
    const removed = await store.change(work).catch(onFailure);
    if (removed) {
      news.tell({ kind: 'removed', id });
    }
    return removed ?? true;
  }

  /** All kept sketches that can be read, the one changed last first. */
  async list(): Promise<LibraryEntry[]> {
    await this.#writer.flushed();
    const heads = await this.#options.store.read(readHeads);
    const entries = await Promise.all(
      heads.map(async ({ id }) => {
        const kept = await this.#read(id);
        this.#listed.set(id, kept?.revision ?? 0);
        return kept ? [{ id, sketch: kept.sketch, changed: kept.changed }] : [];
      }),
    );
    return entries.flat();
  }

  /** Hands everything to the browser at once, as when the page may be gone in a moment. */
  flush(): void {
    leaveLastWords(this.#options.tab, this.#writer.unwritten(this.#track));
    this.#writer.flush();
  }

  /** Settles when everything given so far is written, or has failed. */
  flushed(): Promise<void> {
    return this.#writer.flushed();
  }

  #use(id: string, { revision, whole }: Pick<Kept, 'revision' | 'whole'>): void {
    this.#writer.leave(this.#track);
    this.#track = this.#writer.track(id, { seen: revision, whole });
    this.#remember();
  }

  #remember(): void {
    try {
      this.#options.tab?.setItem(TAB_KEY, this.#track.id);
    } catch {
      // Full or forbidden: after a reload the newest sketch is shown.
    }
  }

  #forked(track: Track): void {
    if (track === this.#track) {
      this.#remember();
    }
    this.#options.onEvent('forked');
  }

  #read(id: string): Promise<Kept | null> {
    return this.#options.store.read((records) => readKept(records, id)).catch(() => null);
  }

  /** Brings sketches of earlier versions of the page into the form of now. What cannot be read stays. */
  async #takeOver(): Promise<void> {
    const { store, newId } = this.#options;
    const old = await store.read((records) => records.under(OLD_PREFIX));
    if (old.length > 0) {
      await store
        .change((records) => takeOver(records, newId))
        .catch((error: unknown) => this.#options.onFailure(error));
    }
  }
}

async function takeOver(records: Writing, newId: () => string): Promise<void> {
  records.delete(OLD_LIST);
  for (const { key, value } of await records.under(OLD_PREFIX)) {
    const fields = (value ?? {}) as Record<string, unknown>;
    const sketch = readSketchValue(fields['sketch']);
    if (key === OLD_LIST || typeof key !== 'string' || !sketch.ok) {
      continue;
    }
    const id = key.slice(OLD_PREFIX.length);
    // A tab with the earlier version may have written it once more.
    const taken = (await readRevision(records, id)) > 0;
    const changed = Number(fields['changed']) || 0;
    const state = { sketch: sketch.value, history: readHistory(fields['history']), settings: null };
    writeFirst(records, { id: taken ? newId() : id, changed }, state);
    records.delete(key);
  }
}
