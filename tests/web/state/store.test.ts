import { describe, expect, it } from 'vitest';
import type { SketchDocument } from '../../../web/src/model/sketch.ts';
import { applyDelta, diffSketch, invertDelta } from '../../../web/src/state/delta.ts';
import { addLines, removeLines } from '../../../web/src/state/edits.ts';
import { SketchStore } from '../../../web/src/state/store.ts';

const EMPTY: SketchDocument = { format: 'technic-sketch', version: 1, lines: [] };

function row(count: number): SketchDocument {
  return addLines(
    EMPTY,
    Array.from({ length: count }, (_, i) => ({ from: [0, i, 0] as const, to: [4, i, 0] as const })),
  );
}

describe('delta', () => {
  it('turns the first sketch into the second and back', () => {
    const before: SketchDocument = { ...row(5), name: 'a', ground: -1 };
    const after: SketchDocument = {
      ...removeLines(row(5), new Set([1, 3])),
      name: 'b',
      keepOut: [{ min: [0, 0, 0], max: [1, 1, 1] }],
    };
    const delta = diffSketch(before, after);
    expect(applyDelta(before, delta)).toEqual(after);
    expect(applyDelta(after, invertDelta(delta))).toEqual(before);
  });

  it('holds only the stretch that changed', () => {
    const before = row(1000);
    const after = removeLines(before, new Set([500]));
    expect(diffSketch(before, after).lines).toEqual({
      at: 500,
      removed: [before.lines[500]],
      added: [],
    });
  });
});

describe('store', () => {
  it('undoes and redoes hundreds of edits', () => {
    const store = new SketchStore();
    for (let i = 1; i <= 300; i++) {
      store.commit('draw', row(i));
    }
    const last = store.sketch.value;
    while (store.undo() !== null);
    expect(store.sketch.value.lines).toEqual([]);
    while (store.redo() !== null);
    expect(store.sketch.value.lines).toEqual(last.lines);
  });

  it('makes one step of a drag', () => {
    const store = new SketchStore();
    store.commit('draw', row(1));
    store.commit('move', row(2), 'later');
    store.commit('move', row(3), 'later');
    store.commit('move', row(4), 'now');
    expect(store.history.value.past).toHaveLength(2);
    store.undo();
    expect(store.sketch.value.lines).toHaveLength(1);
  });

  it('forgets a drag that is given up', () => {
    const store = new SketchStore();
    store.commit('draw', row(1));
    store.commit('move', row(3), 'later');
    store.rollBack();
    expect(store.sketch.value.lines).toHaveLength(1);
    expect(store.save().sketch.lines).toHaveLength(1);
  });

  it('records nothing when nothing changed', () => {
    const store = new SketchStore();
    store.commit('draw', row(2));
    store.commit('draw', row(2));
    expect(store.history.value.past).toHaveLength(1);
  });

  it('drops what could be redone after a new edit', () => {
    const store = new SketchStore();
    store.commit('draw', row(1));
    store.undo();
    store.commit('draw', row(2));
    expect(store.canRedo.value).toBe(false);
  });

  it('keeps what is selected through undo and redo of a move', () => {
    const store = new SketchStore();
    store.commit('draw', row(3));
    store.select([1]);
    const moved = row(3).lines.map((line, i) =>
      i === 1 ? { ...line, to: [5, 1, 0] as const } : line,
    );
    store.commit('move', { ...row(3), lines: moved });
    store.select([1]);
    store.undo();
    expect([...store.selection.value]).toEqual([1]);
    store.redo();
    expect([...store.selection.value]).toEqual([1]);
  });

  it('finds what is selected again where lines come and go', () => {
    const store = new SketchStore();
    store.commit('draw', row(3));
    store.commit('delete', removeLines(row(3), new Set([0])));
    store.select([0]);
    store.undo();
    expect([...store.selection.value]).toEqual([1]);
    store.select([0, 2]);
    store.redo();
    expect([...store.selection.value]).toEqual([1]);
  });
});
