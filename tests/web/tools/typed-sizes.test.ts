import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import { lineLength } from '../../../web/src/model/sketch.ts';
import { SketchStore } from '../../../web/src/state/store.ts';
import type { ToolId } from '../../../web/src/tools/tool.ts';
import { createTools } from '../../../web/src/tools/tool-set.ts';
import { sizesOf, tidySizes } from '../../../web/src/tools/typed-sizes.ts';
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
  const click = (x: number, y: number) => {
    const at = pointerOver([x, y, 0]);
    tool.pointerMove(at);
    tool.pointerDown(at);
    tool.pointerUp(at);
  };
  const press = (keys: string) => {
    for (const key of keys) tool.key({ key, shift: false });
  };
  const enter = () => tool.key({ key: 'Enter', shift: false });
  const lengths = () => store.sketch.value.lines.map(lineLength).sort((a, b) => a - b);
  return { store, tool, click, press, enter, lengths };
}

describe('typed sizes', () => {
  it.each([
    ['6,8,4', 3, '6,8,4'],
    ['6 x 8 × 4', 3, '6,8,4'],
    ['6,', 3, '6,'],
    ['06,,8', 2, '6,8'],
    ['6,8,4,2', 3, '6,8,4'],
    ['1234', 1, '123'],
    ['7,5', 1, '7'],
    ['', 3, ''],
  ])('%s of %i at most is %s', (typed, most, tidy) => {
    expect(tidySizes(typed, most)).toBe(tidy);
  });

  it('are numbers from one up', () => {
    expect(sizesOf('6,8,')).toEqual([6, 8]);
    expect(sizesOf('')).toEqual([]);
  });
});

describe('a box by its sizes', () => {
  const BOX = [4, 4, 4, 4, 6, 6, 6, 6, 8, 8, 8, 8];

  it('is there after Enter, with no click at all', () => {
    const { press, enter, lengths } = begin('box');
    press('6,8,4');
    enter();
    expect(lengths()).toEqual(BOX);
  });

  it('stands at the corner that was clicked, on the side of the pointer', () => {
    const { tool, click, press, enter, store, lengths } = begin('box');
    click(2, 3);
    tool.pointerMove(pointerOver([-1, 5, 0]));
    press('6,8,4');
    enter();
    expect(lengths()).toEqual(BOX);
    const xs = store.sketch.value.lines.flatMap(({ from, to }) => [from[0], to[0]]);
    const ys = store.sketch.value.lines.flatMap(({ from, to }) => [from[1], to[1]]);
    expect([Math.min(...xs), Math.max(...xs)]).toEqual([-4, 2]);
    expect([Math.min(...ys), Math.max(...ys)]).toEqual([3, 11]);
  });

  it('is previewed while it is typed', () => {
    const { tool, press } = begin('box');
    press('6,8,4');
    const { preview, label, typed } = tool.overlay.value;
    expect(1 + (preview?.more?.length ?? 0)).toBe(12);
    expect(label?.main).toBe('6 × 8 × 4');
    expect(typed).toBe('6,8,4');
  });

  it('waits for its height when only the base was typed', () => {
    const { press, enter, lengths } = begin('box');
    press('6,8');
    enter();
    expect(lengths()).toEqual([]);
    press('4');
    enter();
    expect(lengths()).toEqual(BOX);
  });
});

it('a rectangle takes its two sides', () => {
  const { press, enter, lengths } = begin('rectangle');
  press('6,8');
  enter();
  expect(lengths()).toEqual([6, 6, 8, 8]);
});

it('a line takes one length only', () => {
  const { tool, click, press } = begin('line');
  click(0, 0);
  tool.pointerMove(pointerOver([4, 0, 0]));
  press('7,5');
  expect(tool.overlay.value.typed).toBe('75');
});
