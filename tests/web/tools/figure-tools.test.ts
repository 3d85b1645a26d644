import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import { lineLength } from '../../../web/src/model/sketch.ts';
import { SketchStore } from '../../../web/src/state/store.ts';
import type { ToolId } from '../../../web/src/tools/tool.ts';
import { createTools } from '../../../web/src/tools/tool-set.ts';
import { text } from '../../../web/src/ui/text.ts';
import { flatView, pointerOver } from '../helpers/flat-view.ts';

function begin(id: ToolId) {
  const store = new SketchStore();
  const tools = createTools({
    store,
    view: flatView(store),
    joint: signal(null),
    plane: signal('auto'),
    nextPlane: () => undefined,
    announce: () => undefined,
    words: text,
  });
  const tool = tools.get(id);
  if (!tool) throw new Error(id);
  const click = (x: number, y: number, shift = false) => {
    const at = pointerOver([x, y, 0], shift);
    tool.pointerMove(at);
    tool.pointerDown(at);
    tool.pointerUp(at);
  };
  const press = (...keys: string[]) => {
    for (const key of keys) tool.key({ key, shift: false });
  };
  return { store, tool, click, press };
}

const SQUARE = {
  format: 'technic-sketch',
  version: 1,
  lines: [
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [4, 0, 0], to: [4, 6, 0] },
  ],
} as const;

describe('figures', () => {
  it('draws a rectangle of four lines in one step', () => {
    const { store, click } = begin('rectangle');
    click(0, 0);
    click(6, 4);
    expect(store.sketch.value.lines.map(lineLength)).toEqual([6, 4, 6, 4]);
    expect(store.history.value.past).toHaveLength(1);
  });

  it('draws a box of twelve lines', () => {
    const { store, click, press } = begin('box');
    click(0, 0);
    click(6, 4);
    press('PageUp', 'PageUp', 'PageUp', 'Enter');
    const lengths = store.sketch.value.lines.map(lineLength).sort();
    expect(lengths).toEqual([3, 3, 3, 3, 4, 4, 4, 4, 6, 6, 6, 6]);
  });

  it('draws a grid with cells of the typed width', () => {
    const { store, click, press } = begin('grid');
    click(0, 0);
    press('3');
    click(6, 6);
    expect(store.sketch.value.lines).toHaveLength(6);
  });

  it('draws a hexagon of six equal sides', () => {
    const { store, click } = begin('hexagon');
    click(0, 0);
    click(5, 0);
    for (const line of store.sketch.value.lines) {
      expect(lineLength(line)).toBeCloseTo(5, 9);
    }
    expect(store.sketch.value.lines).toHaveLength(6);
  });

  it('sets a keep-out box with its smaller corner first', () => {
    const { store, click, press } = begin('keepOut');
    click(5, 5);
    click(2, 3);
    press('PageDown', 'PageDown', 'Enter');
    expect(store.sketch.value.keepOut).toEqual([{ min: [2, 3, -2], max: [5, 5, 0] }]);
  });
});

describe('nodes', () => {
  it('splits a line at the clicked node', () => {
    const { store, click } = begin('split');
    store.commit('open', SQUARE);
    click(6, 0);
    expect(store.sketch.value.lines.map(lineLength).sort()).toEqual([2, 6, 6]);
  });

  it('sets a joint about the axis square to both lines', () => {
    const { store, click } = begin('joint');
    store.commit('open', SQUARE);
    click(4, 0);
    expect(store.sketch.value.joints).toEqual([{ at: [4, 0, 0], axis: [0, 0, 1] }]);
  });
});

describe('selection', () => {
  it('takes one line by a click and more with Shift', () => {
    const { store, click } = begin('select');
    store.commit('open', SQUARE);
    click(1, 0);
    expect([...store.selection.value]).toEqual([0]);
    click(4, 5, true);
    expect([...store.selection.value]).toEqual([0, 1]);
  });

  it('moves what is selected by whole modules, in one step', () => {
    const { store, tool, click } = begin('select');
    store.commit('open', SQUARE);
    click(4, 5);
    tool.pointerDown(pointerOver([4, 5, 0]));
    tool.pointerMove(pointerOver([5, 5, 0]));
    tool.pointerMove(pointerOver([7.2, 5.3, 0]));
    tool.pointerUp(pointerOver([7.2, 5.3, 0]));
    expect(store.sketch.value.lines[1]).toEqual({ from: [7, 0, 0], to: [7, 6, 0] });
    expect(store.history.value.past).toHaveLength(2);
  });

  it('puts everything back when a drag is given up', () => {
    const { store, tool, click } = begin('select');
    store.commit('open', SQUARE);
    click(4, 5);
    tool.pointerDown(pointerOver([4, 5, 0]));
    tool.pointerMove(pointerOver([9, 5, 0]));
    tool.escape();
    expect(store.sketch.value).toEqual(SQUARE);
  });

  it('takes the lines inside a box', () => {
    const { store, tool } = begin('select');
    store.commit('open', SQUARE);
    tool.pointerDown(pointerOver([3, -1, 0], true));
    tool.pointerMove(pointerOver([4, 5, 0], true));
    tool.pointerUp(pointerOver([5, 7, 0], true));
    expect([...store.selection.value]).toEqual([1]);
  });
});
