import { describe, expect, it } from 'vitest';
import { readKept, STEPS_PER_BASE } from '../../../web/src/state/sketch-records.ts';
import {
  type Key,
  memoryStore,
  type RecordStore,
  type Writing,
} from '../../../web/src/state/storage.ts';
import { Tab } from '../helpers/tabs.ts';

const STEPS = 150;

/** A sketch of so many lines, each drawn in a step of its own and written by itself. */
async function longHistory(store: RecordStore): Promise<Tab> {
  const tab = await new Tab({ store }).begin();
  for (let i = 1; i <= STEPS; i++) {
    tab.draw(i);
    await tab.library.flushed();
  }
  return tab;
}

async function keysUnder(store: RecordStore, prefix: Key): Promise<Key[]> {
  return (await store.read((records) => records.under(prefix))).map(({ key }) => key);
}

/** A store that counts what is written, in characters. */
function counting(store: RecordStore): RecordStore & { written: number } {
  const counted = {
    written: 0,
    read: store.read,
    change: <T>(work: (records: Writing) => Promise<T>) =>
      store.change((records) =>
        work({
          ...records,
          put: (key, value) => {
            counted.written += JSON.stringify(value).length;
            records.put(key, value);
          },
        }),
      ),
  };
  return counted;
}

describe('a kept sketch', () => {
  it('is written as a whole now and then, and comes back with all of its history', async () => {
    const store = memoryStore();
    const tab = await longHistory(store);
    const bases = await keysUnder(store, ['base', tab.library.openId]);
    expect(bases.length).toBeGreaterThan(1);
    expect(bases.length).toBeLessThan(4);
    const later = await new Tab({ store }).begin();
    expect(later.state()).toEqual(tab.state());
    for (let i = 0; i < STEPS; i++) {
      later.sketches.undo();
    }
    expect(later.rows()).toEqual([]);
  });

  it('costs what a step changes, however long the history: 2,000 lines, nudged again and again', async () => {
    const store = counting(memoryStore());
    const tab = await new Tab({ store }).begin();
    const row = (n: number) => (_: unknown, i: number) => ({
      from: [n, i % 40, Math.floor(i / 40)] as const,
      to: [n + 3, i % 40, Math.floor(i / 40)] as const,
    });
    const costs: number[] = [];
    for (let n = 1; n <= 12; n++) {
      const lines = Array.from({ length: 2000 }, row(n));
      tab.sketches.commit('nudge', { ...tab.sketches.sketch.value, lines });
      store.written = 0;
      await tab.library.flushed();
      costs.push(store.written);
    }
    const [whole = 0, ...nudges] = costs;
    // What stood there and what stands there, for undo.
    expect(Math.max(...nudges)).toBeLessThan(2.2 * whole);
    expect((await new Tab({ store }).begin()).state()).toEqual(tab.state());
  });
});

describe('damage', () => {
  async function damaged(change: (records: Writing, id: string) => void) {
    const store = memoryStore();
    const tab = await longHistory(store);
    const id = tab.library.openId;
    await store.change(async (records) => change(records, id));
    return { store, id, kept: await store.read((records) => readKept(records, id)) };
  }

  it('of the head costs nothing', async () => {
    const { store, kept } = await damaged((records, id) => records.put(['head', id], 'gone'));
    expect(kept?.sketch.lines).toHaveLength(STEPS);
    expect(kept?.history.past).toHaveLength(STEPS);
    // And what is drawn then is kept.
    const tab = await new Tab({ store }).begin();
    tab.draw(STEPS + 1);
    await tab.library.flushed();
    expect((await new Tab({ store }).begin()).rows()).toHaveLength(STEPS + 1);
  });

  it('of an early step costs the history before it', async () => {
    const { kept } = await damaged((records, id) =>
      records.put(['step', id, 20], { kind: 'push' }),
    );
    expect(kept?.sketch.lines).toHaveLength(STEPS);
    expect(kept?.history.past).toHaveLength(STEPS - 20);
  });

  it('of a late step costs what came after it, and no more', async () => {
    const { store, kept } = await damaged((records, id) => records.delete(['step', id, STEPS - 3]));
    expect(kept?.sketch.lines).toHaveLength(STEPS - 4);
    const tab = await new Tab({ store }).begin();
    tab.draw(STEPS + 1);
    await tab.library.flushed();
    const later = await new Tab({ store }).begin();
    expect(later.rows()).toHaveLength(STEPS - 3);
    later.sketches.undo();
    expect(later.rows()).toHaveLength(STEPS - 4);
  });

  it('of the newest whole is made good from the one before', async () => {
    const newest = STEPS - (STEPS % STEPS_PER_BASE);
    const { kept } = await damaged((records, id) => {
      records.put(['base', id, newest], { sketch: { lines: 7 } });
    });
    expect(kept?.sketch.lines).toHaveLength(STEPS);
  });

  it('of one sketch does not hide another', async () => {
    const store = memoryStore();
    const tab = await new Tab({ store }).begin();
    await tab.begun('Good');
    await tab.begun('Bad');
    const id = tab.library.openId;
    await store.change(async (records) => records.put(['base', id, 1], null));
    const later = await new Tab({ store }).begin();
    expect(later.state().sketch.name).toBe('Good');
    expect(await later.library.list()).toHaveLength(1);
    expect(await keysUnder(store, ['base', id])).toHaveLength(1);
  });
});

describe('a store that refuses', () => {
  it('is said at once, and what was drawn is kept as soon as there is room', async () => {
    const store = memoryStore();
    let full = true;
    const tab = await new Tab({
      store: {
        read: store.read,
        change: (work) =>
          full ? Promise.reject(new Error('QuotaExceededError')) : store.change(work),
      },
    }).begin();
    tab.draw(1);
    await tab.library.flushed();
    expect(tab.failures).toHaveLength(1);
    expect(tab.library.state).toBe('refused');
    full = false;
    tab.draw(2);
    await tab.library.flushed();
    expect(tab.library.state).toBe('kept');
    expect((await new Tab({ store }).begin()).rows()).toEqual([1, 2]);
  });

  it('in the middle of a write leaves all as it was', async () => {
    const store = memoryStore();
    const tab = await new Tab({ store }).begin();
    tab.draw(1);
    await tab.library.flushed();
    await store
      .change(async (records) => {
        records.deleteUnder(['step', tab.library.openId]);
        records.delete(['head', tab.library.openId]);
        throw new Error('power cut');
      })
      .catch(() => undefined);
    expect((await new Tab({ store }).begin()).rows()).toEqual([1]);
  });
});
