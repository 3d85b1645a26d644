import type { SketchDelta, Splice } from './delta.ts';
import type { History, HistoryEntry } from './history.ts';
import { readSketchValue } from './read-sketch.ts';
import type { KeyValueStore } from './storage.ts';
import type { SavedSketch } from './store.ts';

const KEY = 'sketch/current';
const FORMAT = 1;

/**
 * Writes the sketch and its history after every edit. While one write is under way only the newest
 * state waits, so a fast hand never makes a queue.
 */
export class Autosaver {
  readonly #store: KeyValueStore;
  readonly #onFailure: (error: unknown) => void;
  #waiting: SavedSketch | null = null;
  #writing: Promise<void> | null = null;

  constructor(store: KeyValueStore, onFailure: (error: unknown) => void) {
    this.#store = store;
    this.#onFailure = onFailure;
  }

  /** Puts the state in line; returns at once. */
  save(saved: SavedSketch): void {
    this.#waiting = saved;
    this.#writing ??= this.#drain();
  }

  /** Settles when everything given so far is written, or has failed. */
  async flushed(): Promise<void> {
    await this.#writing;
  }

  async #drain(): Promise<void> {
    while (this.#waiting) {
      const next = this.#waiting;
      this.#waiting = null;
      try {
        await this.#store.set(KEY, { format: FORMAT, ...next });
      } catch (error) {
        this.#onFailure(error);
      }
    }
    this.#writing = null;
  }
}

/** What an earlier visit left, or null. Trusts nothing: a damaged history is dropped, a damaged sketch too. */
export async function loadSaved(store: KeyValueStore): Promise<SavedSketch | null> {
  const value = await store.get(KEY);
  if (!isRecord(value) || value['format'] !== FORMAT) {
    return null;
  }
  const sketch = readSketchValue(value['sketch']);
  if (!sketch.ok) {
    return null;
  }
  return { sketch: sketch.value, history: readHistory(value['history']) };
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
