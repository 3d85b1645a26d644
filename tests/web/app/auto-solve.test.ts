import { signal } from '@preact/signals';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { type Search, solveAfterEdits } from '../../../web/src/app/auto-solve.ts';
import { PageController } from '../../../web/src/app/page-controller.ts';
import type { PageState } from '../../../web/src/app/page-state.ts';
import type { Wish } from '../../../web/src/app/solve-run.ts';
import { Catalogue } from '../../../web/src/model/catalogue.ts';
import type { SketchDocument } from '../../../web/src/model/sketch.ts';
import { PREFERENCE_DEFAULTS } from '../../../web/src/state/preferences.ts';
import { SketchStore } from '../../../web/src/state/store.ts';
import type { ShownModel } from '../../../web/src/ui/page.ts';
import { partsText, settingsOf } from '../../../web/src/ui/solve-settings.ts';
import { silentClient } from '../helpers/silent-client.ts';

const sketchOf = (count: number): SketchDocument => ({
  format: 'technic-sketch',
  version: 1,
  lines: Array.from({ length: count }, (_, i) => ({ from: [0, i, 0], to: [4, i, 0] })),
});

function begin(autoSolve = true) {
  const store = new SketchStore();
  const preferences = signal({ ...PREFERENCE_DEFAULTS, autoSolve });
  const controller = new PageController({
    store,
    preferences,
    catalogue: new Catalogue([]),
    client: silentClient(),
  });
  const did: string[] = [];
  let underWay: Wish | null = null;
  const search: Search = {
    generate: () => {
      did.push('generate');
      underWay = { sketch: store.sketch.value, parts: partsText(settingsOf(preferences.value)) };
    },
    drop: () => {
      did.push('drop');
      underWay = null;
    },
    wishUnderWay: () => underWay,
  };
  const shown = signal<ShownModel | null>(null);
  const state: PageState = Object.assign(Object.create(controller.state), { shown });
  const stop = solveAfterEdits(state, search);
  const own = (owned: Readonly<Record<string, number>>) => {
    preferences.value = { ...preferences.value, owned };
  };
  const look = () => {
    preferences.value = { ...preferences.value, show: 'model' };
  };
  const edit = (count: number) => {
    store.commit('draw', sketchOf(count));
  };
  /** The search that was started has ended. */
  const end = () => {
    const report = { buildable: true } as ShownModel['report'];
    shown.value = { ...underWay, report } as ShownModel;
    underWay = null;
  };
  return { did, edit, look, own, shown, store, search, end, stop };
}

describe('solving after edits', () => {
  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it('waits for a pause and then starts once', () => {
    const { did, edit } = begin();
    edit(1);
    vi.advanceTimersByTime(200);
    edit(2);
    vi.advanceTimersByTime(200);
    expect(did).toEqual([]);
    vi.advanceTimersByTime(1000);
    expect(did).toEqual(['generate']);
  });

  it('gives up the search for an older sketch', () => {
    const { did, edit } = begin();
    edit(1);
    vi.advanceTimersByTime(1000);
    edit(2);
    expect(did).toEqual(['generate', 'drop']);
    vi.advanceTimersByTime(1000);
    expect(did).toEqual(['generate', 'drop', 'generate']);
  });

  it('does not start again what a person has started already', () => {
    const { did, edit, search } = begin();
    edit(1);
    search.generate();
    vi.advanceTimersByTime(1000);
    expect(did).toEqual(['generate']);
  });

  it('does not start again what a person has started and what has ended before the pause', () => {
    const { did, edit, search, end } = begin();
    edit(1);
    search.generate();
    end();
    vi.advanceTimersByTime(1000);
    expect(did).toEqual(['generate']);
  });

  it('searches again for the same drawing with the parts that there are now', () => {
    const { did, edit, own, end } = begin();
    edit(1);
    vi.advanceTimersByTime(1000);
    end();
    own({ 32316: 1 });
    vi.advanceTimersByTime(1000);
    expect(did).toEqual(['generate', 'generate']);
    // Parts that are counted as before change nothing.
    end();
    own({ 32316: 1 });
    vi.advanceTimersByTime(1000);
    expect(did).toEqual(['generate', 'generate']);
  });

  it('gives up the search for the parts before', () => {
    const { did, edit, own } = begin();
    edit(1);
    vi.advanceTimersByTime(1000);
    own({ 2780: 4 });
    expect(did).toEqual(['generate', 'drop']);
  });

  it('leaves a new name alone', () => {
    const { did, edit, store } = begin();
    edit(1);
    vi.advanceTimersByTime(1000);
    store.commit('rename', { ...store.sketch.value, name: 'Crane' });
    vi.advanceTimersByTime(1000);
    expect(did).toEqual(['generate']);
  });

  it.each([
    ['a large sketch', true, 500],
    ['any sketch when it is switched off', false, 1],
    ['an empty sketch', true, 0],
  ])('leaves %s to the button', (_name, autoSolve, count) => {
    const { did, edit } = begin(autoSolve);
    edit(count);
    vi.advanceTimersByTime(5000);
    expect(did).toEqual([]);
  });

  it('leaves the model of a file that was opened over a drawing', () => {
    const { did, edit, look, shown } = begin();
    const report = { buildable: true };
    shown.value = { sketch: sketchOf(1), parts: null, report } as ShownModel;
    edit(1);
    shown.value = { sketch: null, parts: null, report } as ShownModel;
    look();
    vi.advanceTimersByTime(1000);
    expect(did).toEqual([]);
  });
});
