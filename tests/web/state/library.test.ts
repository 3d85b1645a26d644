import { describe, expect, it } from 'vitest';
import { emptySketch } from '../../../web/src/model/sketch.ts';
import { addLines } from '../../../web/src/state/edits.ts';
import { SketchLibrary } from '../../../web/src/state/library.ts';
import { type KeyValueStore, memoryStore } from '../../../web/src/state/storage.ts';
import type { SavedSketch } from '../../../web/src/state/store.ts';

const NO_HISTORY = { past: [], future: [] };

function named(name: string): SavedSketch {
  const sketch = addLines(emptySketch(name), [{ from: [0, 0, 0], to: [3, 0, 0] }]);
  return { sketch, history: NO_HISTORY };
}

function tabStorage(): Pick<Storage, 'getItem' | 'setItem'> {
  const values = new Map<string, string>();
  return {
    getItem: (key) => values.get(key) ?? null,
    setItem: (key, value) => {
      values.set(key, value);
    },
  };
}

let nextId = 0;

function library(store: KeyValueStore, tab = tabStorage()): SketchLibrary {
  const newId = () => `id-${nextId++}`;
  return new SketchLibrary({ store, tab, newId, onFailure: () => undefined });
}

async function withTwo(store: KeyValueStore, tab = tabStorage()): Promise<SketchLibrary> {
  const shelf = library(store, tab);
  await shelf.begin();
  shelf.save(named('Table'));
  shelf.startNew();
  shelf.save(named('Chair'));
  await shelf.flushed();
  return shelf;
}

describe('the library of sketches', () => {
  it('keeps each sketch under its own name, the last changed first', async () => {
    const shelf = await withTwo(memoryStore());
    const names = (await shelf.list()).map((entry) => entry.sketch.name);
    expect(names).toEqual(['Chair', 'Table']);
  });

  it('opens in each tab what that tab showed last', async () => {
    const store = memoryStore();
    const first = tabStorage();
    await withTwo(store, first);
    const second = library(store);
    await second.begin();
    const table = (await second.list()).find((entry) => entry.sketch.name === 'Table');
    await second.open(table?.id ?? '');
    second.save(named('Table'));
    await second.flushed();

    expect((await library(store, first).begin())?.sketch.name).toBe('Chair');
    expect((await library(store).begin())?.sketch.name).toBe('Table');
  });

  it('finds the one sketch that an earlier version of the page kept', async () => {
    const store = memoryStore();
    await store.set('sketch/current', { format: 1, ...named('Old') });
    expect((await library(store).begin())?.sketch.name).toBe('Old');
  });

  it('does not keep a sketch that nothing was ever drawn in', async () => {
    const shelf = library(memoryStore());
    await shelf.begin();
    shelf.save({ sketch: emptySketch(), history: NO_HISTORY });
    expect(await shelf.list()).toEqual([]);
  });

  it('removes one and leaves the others', async () => {
    const shelf = await withTwo(memoryStore());
    const [, table] = await shelf.list();
    await shelf.remove(table?.id ?? '');
    expect((await shelf.list()).map((entry) => entry.sketch.name)).toEqual(['Chair']);
  });

  it('says that a sketch is not safe while the store refuses it', async () => {
    const full: KeyValueStore = {
      ...memoryStore(),
      set: () => Promise.reject(new Error('QuotaExceededError')),
    };
    const shelf = library(full);
    await shelf.begin();
    shelf.save(named('Lost'));
    await shelf.flushed();
    expect(shelf.unsaved).toBe(true);
  });
});
