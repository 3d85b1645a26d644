import {
  type KeptState,
  type KeptStep,
  readRevision,
  writeFirst,
  writeSteps,
} from './sketch-records.ts';
import type { RecordStore } from './storage.ts';

/** A sketch as this tab knows it. Its id changes when another tab came between: see SketchWriter. */
export interface Track {
  readonly id: string;
  /** The newest revision that this tab has seen or written; 0 for a sketch that is not kept yet. */
  readonly seen: number;
  /** Whether something waits to be written. */
  readonly waiting: boolean;
}

interface OwnTrack extends Track {
  id: string;
  seen: number;
  waiting: boolean;
  steps: KeptStep[];
  /** The sketch after all steps; null before the first. */
  after: KeptState | null;
  /** What is kept could not be read in whole: the next write begins anew. */
  anew: boolean;
  left: boolean;
}

export interface WriterOptions {
  readonly store: RecordStore;
  readonly newId: () => string;
  readonly onWritten: (id: string, revision: number) => void;
  /** Another tab has changed or deleted the sketch: what was drawn here is kept under another id. */
  readonly onForked: (track: Track) => void;
  readonly onFailure: (error: unknown) => void;
  /** Told whenever `state` may have changed. */
  readonly onState: () => void;
}

/** `kept`: all is safe; `writing`: it will be in a moment; `refused`: the browser does not take it. */
export type WriterState = 'kept' | 'writing' | 'refused';

/**
 * Writes the steps of sketches. Nothing is overwritten that this tab has not seen: each write looks, in the same
 * transaction, whether the sketch is still the one that its steps were made on. If it is not, the sketch as it is
 * here becomes one of its own beside the other. What the browser refuses stays in line and is tried again with the
 * next step.
 */
export class SketchWriter {
  readonly #options: WriterOptions;
  readonly #tracks = new Set<OwnTrack>();
  #underWay = 0;
  #refused = false;
  #last: Promise<void> = Promise.resolve();
  #stamp = 0;

  constructor(options: WriterOptions) {
    this.#options = options;
  }

  get state(): WriterState {
    if (this.#refused) {
      return 'refused';
    }
    return this.#underWay > 0 ? 'writing' : 'kept';
  }

  /** @param seen the revision that is on the page, 0 for a new sketch. */
  track(id: string, { seen, whole }: { seen: number; whole: boolean }): Track {
    const track: OwnTrack = {
      id,
      seen,
      waiting: false,
      steps: [],
      after: null,
      anew: !whole,
      left: false,
    };
    this.#tracks.add(track);
    return track;
  }

  /** Forgets a track once what waits in it is written. */
  leave(track: Track): void {
    const own = track as OwnTrack;
    own.left = true;
    if (!own.waiting) {
      this.#tracks.delete(own);
    }
  }

  /** What was read again of a sketch that other tabs have changed. */
  adopt(track: Track, kept: { revision: number; whole: boolean }): void {
    const own = track as OwnTrack;
    own.seen = kept.revision;
    own.anew = !kept.whole;
    own.after = null;
  }

  /** Puts steps in line; returns at once. None are needed to keep a sketch for the first time. */
  add(track: Track, steps: readonly KeptStep[], after: KeptState): void {
    const own = track as OwnTrack;
    own.steps.push(...steps);
    own.after = after;
    own.waiting = true;
    // While one write is under way the next ones wait for it together.
    if (this.#underWay === 0) {
      this.flush();
    } else {
      this.#options.onState();
    }
  }

  /** Hands everything to the browser now, without waiting for a write that is under way. */
  flush(): void {
    this.#underWay += 1;
    this.#options.onState();
    const before = this.#last;
    this.#last = this.#writeAll().then(() => before);
  }

  /** What a write has not confirmed yet, with the revision that it is made on; null when all is written. */
  unwritten(track: Track): { id: string; seen: number; after: KeptState } | null {
    const { id, seen, after } = track as OwnTrack;
    return this.#underWay > 0 && after !== null ? { id, seen, after } : null;
  }

  /** Settles when everything given so far is written, or has failed. */
  async flushed(): Promise<void> {
    for (let last: unknown = null; last !== this.#last; ) {
      last = this.#last;
      await this.#last;
    }
  }

  async #writeAll(): Promise<void> {
    try {
      for (const track of this.#tracks) {
        if (track.waiting) {
          await this.#write(track);
        }
        if (track.left && !track.waiting) {
          this.#tracks.delete(track);
        }
      }
      this.#refused = false;
    } catch (error) {
      this.#refused = true;
      this.#options.onFailure(error);
    }
    this.#underWay -= 1;
    const more = !this.#refused && [...this.#tracks].some(({ waiting }) => waiting);
    if (more && this.#underWay === 0) {
      this.flush();
    } else {
      this.#options.onState();
    }
  }

  async #write(track: OwnTrack): Promise<void> {
    let steps: KeptStep[] = [];
    let revision = track.seen;
    let known = true;
    try {
      await this.#options.store.change(async (records) => {
        const newest = await readRevision(records, track.id);
        // As late as may be: what was drawn while this write waited for its turn goes with it.
        const { after } = track;
        if (!track.waiting || after === null) {
          return;
        }
        known = newest === track.seen;
        if (!known) {
          return;
        }
        steps = track.steps.splice(0);
        track.waiting = false;
        const now = { id: track.id, changed: this.#now() };
        revision =
          track.seen === 0
            ? writeFirst(records, now, after)
            : await writeSteps(
                records,
                { ...now, revision: track.seen },
                { steps, after, anew: track.anew },
              );
      });
    } catch (error) {
      track.steps.unshift(...steps);
      track.waiting = true;
      throw error;
    }
    if (!known) {
      this.#fork(track);
      await this.#write(track);
    } else if (revision !== track.seen) {
      track.seen = revision;
      track.anew = false;
      this.#options.onWritten(track.id, revision);
    }
  }

  #fork(track: OwnTrack): void {
    track.id = this.#options.newId();
    track.seen = 0;
    track.steps = [];
    track.anew = false;
    this.#options.onForked(track);
  }

  /** Other tabs have written until then: what is written here from now on is later, also within a millisecond. */
  notBefore(stamp: number): void {
    this.#stamp = Math.max(this.#stamp, stamp);
  }

  /** Later than whatever this tab wrote before, even within a millisecond. */
  #now(): number {
    this.#stamp = Math.max(Date.now(), this.#stamp + 1);
    return this.#stamp;
  }
}
