import { describe, expect, it } from 'vitest';
import { readSketchValue } from '../../../web/src/state/read-sketch.ts';
import { readKept } from '../../../web/src/state/sketch-records.ts';
import { type KeptRecord, memoryStore, type RecordStore } from '../../../web/src/state/storage.ts';
import { random } from '../helpers/mutate-link.ts';
import { Tab } from '../helpers/tabs.ts';

const DAMAGES = 400;
const ODD = [
  null,
  undefined,
  0,
  -1,
  1e300,
  Number.NaN,
  '',
  'x',
  true,
  [],
  {},
  [null],
  [[]],
  { at: 0 },
];

type Next = () => number;

function pick<T>(list: readonly T[], next: Next): T | undefined {
  return list[Math.floor(next() * list.length)];
}

/** A copy in which one value, however deep, is an odd one, or gone. */
function damaged(value: unknown, next: Next): unknown {
  const inside = typeof value === 'object' && value !== null ? Object.keys(value) : [];
  const key = pick(inside, next);
  if (key === undefined || next() < 0.15) {
    return pick(ODD, next);
  }
  const copy = structuredClone(value) as Record<string, unknown>;
  if (next() < 0.1) {
    delete copy[key];
  } else {
    copy[key] = damaged(copy[key], next);
  }
  return copy;
}

/** A sketch with all that a sketch can have, its history, and another one. */
async function twoSketches(): Promise<{ store: RecordStore; id: string }> {
  const store = memoryStore();
  const tab = await new Tab({ store }).begin();
  await tab.begun('Other');
  await tab.begun('Damaged');
  const { sketches } = tab;
  const edit = (label: string, change: object) =>
    sketches.commit(label, { ...sketches.sketch.value, ...change });
  tab.draw(1);
  tab.draw(2);
  edit('joint', {
    version: 2,
    joints: [{ at: [0, 0, 0], axis: [0, 0, 1], between: [[0], [1]], range: [-90, 90] }],
  });
  edit('mirror', { symmetries: [{ kind: 'reflection', normal: [1, 0, 0], offset: 1.5 }] });
  edit('box', { keepOut: [{ min: [5, 5, 5], max: [6, 6, 6] }] });
  edit('shaft', { shafts: [{ from: [1, 0, 0], to: [1, 2, 0], bearings: [0, 2] }] });
  edit('colours', { colours: { default: 4, lines: { '0': 1 } } });
  edit('name', { name: 'Damaged again' });
  edit('ground', { ground: 0 });
  sketches.undo();
  sketches.undo();
  tab.record([{ kind: 'settings', settings: null }]);
  await tab.library.flushed();
  return { store, id: tab.library.openId };
}

describe('records with one odd value anywhere', () => {
  it('are opened without a fault, with a sketch that can be read, and hide no other', async () => {
    const { store, id } = await twoSketches();
    const all: KeptRecord[] = [];
    for (const prefix of ['head', 'base', 'step']) {
      all.push(...(await store.read((records) => records.under([prefix]))));
    }
    const own = all.filter(({ key }) => key[1] === id);
    const next = random(3);
    for (let i = 0; i < DAMAGES; ++i) {
      const copy = memoryStore();
      const hit = pick(own, next);
      await copy.change(async (records) => {
        for (const record of all) {
          records.put(record.key, record === hit ? damaged(record.value, next) : record.value);
        }
      });
      const kept = await copy.read((records) => readKept(records, id));
      expect(kept === null || readSketchValue(kept.sketch).ok).toBe(true);
      const tab = await new Tab({ store: copy }).begin();
      const names = (await tab.library.list()).map(({ sketch }) => sketch.name);
      expect(names).toContain('Other');
      // Whatever its history is worth, all of it can be undone and done again.
      for (let step = 0; step < 12; ++step) {
        tab.sketches.undo();
        expect(readSketchValue(tab.sketches.sketch.value).ok).toBe(true);
      }
      for (let step = 0; step < 14; ++step) {
        tab.sketches.redo();
        expect(readSketchValue(tab.sketches.sketch.value).ok).toBe(true);
      }
      expect(tab.failures).toEqual([]);
    }
  });
});
