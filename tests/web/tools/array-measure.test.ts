import { signal } from '@preact/signals';
import { expect, it } from 'vitest';
import { SketchStore } from '../../../web/src/state/store.ts';
import type { ToolId } from '../../../web/src/tools/tool.ts';
import { createTools } from '../../../web/src/tools/tool-set.ts';
import { text } from '../../../web/src/ui/text.ts';
import { flatView, pointerOver } from '../helpers/flat-view.ts';

function begin(id: ToolId) {
  const store = new SketchStore();
  store.commit('draw', {
    format: 'technic-sketch',
    version: 1,
    lines: [
      { from: [0, 0, 0], to: [0, 5, 0] },
      { from: [0, 5, 0], to: [3, 5, 0] },
      { from: [3, 5, 0], to: [3, 0, 0] },
      { from: [3, 5, 0], to: [9, 5, 0] },
    ],
  });
  const said: string[] = [];
  const tools = createTools({
    store,
    view: flatView(store),
    joint: signal(null),
    plane: signal('auto'),
    nextPlane: () => undefined,
    announce: (message) => said.push(message),
    words: text,
  });
  const tool = tools.get(id);
  if (!tool) throw new Error(id);
  const click = (x: number, y: number, double = false) => {
    const at = { ...pointerOver([x, y, 0]), double };
    tool.pointerMove(at);
    tool.pointerDown(at);
    tool.pointerUp(at);
  };
  return { store, tool, click, said };
}

it('an array puts as many copies in a row as were typed, in one step', () => {
  const { store, tool, click } = begin('array');
  store.select([0]);
  click(0, 0);
  tool.key({ key: '4', shift: false });
  click(-2, 0);
  const added = store.sketch.value.lines.slice(4);
  expect(added.map((line) => line.from[0])).toEqual([-2, -4, -6, -8]);
  expect(store.history.value.past).toHaveLength(2);
});

it('an array of nothing changes nothing', () => {
  const { store, click } = begin('array');
  click(0, 0);
  click(-2, 0);
  expect(store.sketch.value.lines).toHaveLength(4);
});

it('measuring says the distance and changes nothing', () => {
  const { store, click, said } = begin('measure');
  const before = store.sketch.value;
  click(0, 0);
  click(3, 5);
  expect(said.at(-1)).toContain('5.83 modules (46.6 mm): 3 along X, 5 along Y, 0 along Z');
  expect(store.sketch.value).toBe(before);
});

it('a double click selects the chain up to where lines branch off', () => {
  const { store, click } = begin('select');
  click(0, 2, true);
  expect([...store.selection.value].sort()).toEqual([0, 1]);
});
