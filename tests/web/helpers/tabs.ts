import { emptySketch } from '../../../web/src/model/sketch.ts';
import { addLines } from '../../../web/src/state/edits.ts';
import { SketchLibrary, type TabEvent } from '../../../web/src/state/library.ts';
import type { KeptState, KeptStep } from '../../../web/src/state/sketch-records.ts';
import type { RecordStore } from '../../../web/src/state/storage.ts';
import { SketchStore } from '../../../web/src/state/store.ts';
import type { News, TabNews } from '../../../web/src/state/tab-news.ts';

/** What a tab keeps for itself. */
export function tabStorage(): Pick<Storage, 'getItem' | 'setItem'> {
  const values = new Map<string, string>();
  return {
    getItem: (key) => values.get(key) ?? null,
    setItem: (key, value) => {
      values.set(key, value);
    },
  };
}

/** A channel between tabs, without a browser; news come at once. */
export class NewsRoom {
  readonly #hearers: { hear: (news: News) => void; open: boolean }[] = [];

  open(): TabNews & { close(): void } {
    const place = { hear: (_: News): void => undefined, open: true };
    this.#hearers.push(place);
    return {
      tell: (news) => {
        for (const other of this.#hearers) {
          if (place.open && other.open && other !== place) {
            other.hear(news);
          }
        }
      },
      listen: (hear) => {
        place.hear = hear;
      },
      close: () => {
        place.open = false;
      },
    };
  }
}

let ids = 0;

interface TabOptions {
  readonly store: RecordStore;
  readonly news?: NewsRoom;
  readonly storage?: Pick<Storage, 'getItem' | 'setItem'>;
}

/** A tab without a page: a store and a library, wired as the page does. */
export class Tab {
  readonly sketches = new SketchStore();
  readonly library: SketchLibrary;
  readonly events: TabEvent[] = [];
  readonly failures: unknown[] = [];
  readonly #news: ReturnType<NewsRoom['open']>;

  constructor({ store, news = new NewsRoom(), storage = tabStorage() }: TabOptions) {
    this.#news = news.open();
    this.library = new SketchLibrary({
      store,
      tab: storage,
      news: this.#news,
      newId: () => `id-${ids++}`,
      onFailure: (error) => this.failures.push(error),
      onEvent: (event) => this.events.push(event),
      onState: () => undefined,
    });
    this.sketches.listen((step) => this.record([step]));
  }

  async begin(): Promise<this> {
    const saved = await this.library.begin();
    if (saved) {
      this.sketches.restore(saved);
    }
    return this;
  }

  record(steps: readonly KeptStep[]): void {
    this.library.record(steps, this.state());
  }

  state(): KeptState {
    return { ...this.sketches.save(), settings: null };
  }

  /** Draws a line that no other call draws. */
  draw(y: number): void {
    const line = { from: [0, y, 0], to: [3, y, 0] } as const;
    this.sketches.commit('draw', addLines(this.sketches.sketch.value, [line]));
  }

  /** Begins a sketch of this name, with a line. */
  async begun(name: string): Promise<void> {
    this.library.startNew();
    this.sketches.restore({ sketch: emptySketch(name), history: { past: [], future: [] } });
    this.draw(0);
    await this.library.flushed();
  }

  async open(id: string): Promise<void> {
    const saved = await this.library.open(id);
    if (saved) {
      this.sketches.restore(saved);
    }
  }

  async follow(): Promise<void> {
    await this.library.follow((kept) => {
      this.sketches.restore(kept);
      return true;
    });
  }

  /** Nothing that it does is heard or written any more, as far as it has not been handed over. */
  close(): void {
    this.#news.close();
  }

  rows(): number[] {
    return rowsOf(this.state());
  }
}

/** The rows in which lines were drawn. */
export function rowsOf(state: Pick<KeptState, 'sketch'>): number[] {
  return state.sketch.lines.map(({ from }) => from[1]).sort((a, b) => a - b);
}
