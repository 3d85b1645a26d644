import { describe, expect, it } from 'vitest';
import { Autosaver, loadSaved } from '../../../web/src/state/autosave.ts';
import { addLines } from '../../../web/src/state/edits.ts';
import { type KeyValueStore, memoryStore } from '../../../web/src/state/storage.ts';
import { SketchStore } from '../../../web/src/state/store.ts';

const KEY = 'sketch/a';

function drawn(): SketchStore {
  const store = new SketchStore();
  store.commit('draw', addLines(store.sketch.value, [{ from: [0, 0, 0], to: [3, 0, 0] }]));
  store.commit('draw', addLines(store.sketch.value, [{ from: [3, 0, 0], to: [3, 4, 0] }]));
  return store;
}

describe('autosave', () => {
  it('brings back the sketch with its history', async () => {
    const kept = memoryStore();
    const saver = new Autosaver(kept, () => undefined);
    const store = drawn();
    saver.save(KEY, store.save());
    await saver.flushed();

    const saved = await loadSaved(kept, KEY);
    const later = new SketchStore();
    if (saved) later.restore(saved);
    expect(later.sketch.value).toEqual(store.sketch.value);
    later.undo();
    expect(later.sketch.value.lines).toHaveLength(1);
  });

  it('writes the newest state when many come at once', async () => {
    const written: unknown[] = [];
    const slow: KeyValueStore = {
      get: async () => undefined,
      delete: async () => undefined,
      set: async (_key, value) => {
        await Promise.resolve();
        written.push(value);
      },
    };
    const saver = new Autosaver(slow, () => undefined);
    const store = drawn();
    for (let i = 0; i < 50; i++) {
      saver.save(KEY, store.save());
    }
    await saver.flushed();
    expect(written.length).toBeLessThan(4);
    expect(written.at(-1)).toMatchObject({ sketch: store.sketch.value });
  });

  it('says that the store is full', async () => {
    const full: KeyValueStore = {
      get: async () => undefined,
      delete: async () => undefined,
      set: async () => Promise.reject(new Error('QuotaExceededError')),
    };
    const failures: unknown[] = [];
    const saver = new Autosaver(full, (error) => failures.push(error));
    saver.save(KEY, drawn().save());
    await saver.flushed();
    expect(failures).toHaveLength(1);
  });

  it.each([
    ['nothing', undefined],
    ['another format', { format: 99, sketch: {} }],
    ['a damaged sketch', { format: 1, sketch: { lines: 'no' } }],
  ])('does not trust %s', async (_name, value) => {
    const kept = memoryStore();
    await kept.set(KEY, value);
    expect(await loadSaved(kept, KEY)).toBeNull();
  });

  it('keeps the sketch when only the history is damaged', async () => {
    const kept = memoryStore();
    const { sketch } = drawn().save();
    await kept.set(KEY, { format: 1, sketch, history: { past: [7], future: [] } });
    expect(await loadSaved(kept, KEY)).toEqual({
      sketch,
      history: { past: [], future: [] },
      changed: 0,
    });
  });
});
