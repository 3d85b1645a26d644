import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import { commandTable } from '../../../web/src/app/commands.ts';
import { PageController } from '../../../web/src/app/page-controller.ts';
import { Catalogue } from '../../../web/src/model/catalogue.ts';
import { PREFERENCE_DEFAULTS } from '../../../web/src/state/preferences.ts';
import { SketchStore } from '../../../web/src/state/store.ts';
import { silentClient } from '../helpers/silent-client.ts';

function begin() {
  const store = new SketchStore();
  const controller = new PageController({
    store,
    preferences: signal(PREFERENCE_DEFAULTS),
    catalogue: new Catalogue([]),
    client: silentClient(),
  });
  return { store, controller, table: commandTable(controller) };
}

/** Keys that mean the same press. */
function normal(shortcut: string): string {
  return shortcut.split('+').sort().join('+').toLowerCase();
}

describe('commands', () => {
  it('have ids of their own', () => {
    const ids = begin().table.all.map(({ id }) => id);
    expect(new Set(ids).size).toBe(ids.length);
  });

  it('have shortcuts of their own', () => {
    const keys = begin().table.all.flatMap(({ shortcut }) => (shortcut ? [normal(shortcut)] : []));
    expect(new Set(keys).size).toBe(keys.length);
  });

  it('each have a label that no other has', () => {
    const labels = begin().table.all.map(({ label }) => label);
    expect(labels.every((label) => label.trim() !== '')).toBe(true);
    expect(new Set(labels).size).toBe(labels.length);
  });

  it('do nothing to an empty sketch that they say they cannot do', () => {
    const { table } = begin();
    expect(table.run('delete')).toBe(false);
    expect(table.run('undo')).toBe(false);
    expect(table.run('generate')).toBe(false);
    expect(table.run('saveMpd')).toBe(false);
  });

  it('mirror the selection beside itself', () => {
    const { table, store } = begin();
    store.commit('draw', {
      ...store.sketch.value,
      lines: [{ from: [0, 0, 0], to: [4, 3, 0] }],
    });
    table.run('selectAll');
    table.run('mirrorX');
    expect(store.sketch.value.lines[1]).toEqual({ from: [8, 0, 0], to: [4, 3, 0] });
  });

  it('paste a copy beside the original and select it', () => {
    const { table, store } = begin();
    store.commit('draw', {
      ...store.sketch.value,
      lines: [{ from: [0, 0, 0], to: [4, 0, 0] }],
    });
    table.run('selectAll');
    table.run('copy');
    table.run('paste');
    table.run('paste');
    expect(store.sketch.value.lines.map(({ from }) => from)).toEqual([
      [0, 0, 0],
      [2, 2, 0],
      [4, 4, 0],
    ]);
    expect([...store.selection.value]).toEqual([2]);
  });

  it('bring everything back that a new sketch took away', () => {
    const { table, store } = begin();
    const lines = [{ from: [0, 0, 0], to: [4, 0, 0] }] as const;
    store.commit('draw', { ...store.sketch.value, lines });
    table.run('new');
    expect(store.sketch.value.lines).toEqual([]);
    table.run('undo');
    expect(store.sketch.value.lines).toEqual(lines);
  });
});
