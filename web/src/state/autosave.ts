import type { SketchDelta, Splice } from './delta.ts';
import type { History, HistoryEntry } from './history.ts';
import { readSketchValue } from './read-sketch.ts';
import type { KeyValueStore } from './storage.ts';
import type { SavedSketch } from './store.ts';

const FORMAT = 1;

/**
 * Writes a sketch and its history after every edit. While one write is under way only the newest
 * state of each sketch waits, so a fast hand never makes a queue.
 */
export class Autosaver {
  readonly #store: KeyValueStore;
  readonly #onFailure: (error: unknown) => void;
  readonly #waiting = new Map<string, SavedSketch>();
  #writing: Promise<void> | null = null;
  #unsaved = false;

  constructor(store: KeyValueStore, onFailure: (error: unknown) => void) {
    this.#store = store;
    this.#onFailure = onFailure;
  }

  /** Whether the browser has refused the last write. One under way takes a moment, and is none. */
  get unsaved(): boolean {
    return this.#unsaved;
  }

  /** Puts the state in line; returns at once. */
  save(key: string, saved: SavedSketch): void {
    this.#waiting.set(key, saved);
    this.#writing ??= this.#drain();
  }

  /** Settles when everything given so far is written, or has failed. */
  async flushed(): Promise<void> {
    await this.#writing;
  }

  async #drain(): Promise<void> {
    for (let next = this.#next(); next; next = this.#next()) {
      const [key, saved] = next;
      try {
        await this.#store.set(key, { format: FORMAT, changed: Date.now(), ...saved });
        this.#unsaved = false;
      } catch (error) {
        this.#unsaved = true;
        this.#onFailure(error);
      }
    }
    this.#writing = null;
  }

  #next(): [string, SavedSketch] | null {
    const [first] = this.#waiting;
    if (!first) {
      return null;
    }
    this.#waiting.delete(first[0]);
    return first;
  }
}

/** A sketch as it was kept, and when. */
export interface KeptSketch extends SavedSketch {
  /** Milliseconds since 1970; 0 when not known. */
  readonly changed: number;
}

/** What is kept under a key, or null. Trusts nothing: a damaged history is dropped, a damaged sketch too. */
export async function loadSaved(store: KeyValueStore, key: string): Promise<KeptSketch | null> {
  const value = await store.get(key);
  if (!isRecord(value) || value['format'] !== FORMAT) {
    return null;
  }
  const sketch = readSketchValue(value['sketch']);
  if (!sketch.ok) {
    return null;
  }
  const changed = Number(value['changed']);
  return {
    sketch: sketch.value,
    history: readHistory(value['history']),
    changed: Number.isFinite(changed) ? changed : 0,
  };
}

function readHistory(value: unknown): History {
  if (!isRecord(value) || !isEntries(value['past']) || !isEntries(value['future'])) {
    return { past: [], future: [] };
  }
  return { past: value['past'], future: value['future'] };
}

function isEntries(value: unknown): value is readonly HistoryEntry[] {
  return Array.isArray(value) && value.every(isEntry);
}

function isEntry(value: unknown): value is HistoryEntry {
  return isRecord(value) && typeof value['label'] === 'string' && isDelta(value['delta']);
}

function isDelta(value: unknown): value is SketchDelta {
  if (!isRecord(value)) {
    return false;
  }
  const lists = ['lines', 'joints', 'symmetries', 'keepOut'];
  return lists.every((key) => value[key] === undefined || isSplice(value[key]));
}

function isSplice(value: unknown): value is Splice<unknown> {
  return (
    isRecord(value) &&
    Number.isInteger(value['at']) &&
    Array.isArray(value['removed']) &&
    Array.isArray(value['added'])
  );
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
