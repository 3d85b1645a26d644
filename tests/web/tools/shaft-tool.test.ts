import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import {
  clearShafts,
  couple,
  isLegalShaft,
  lastPair,
  withEnds,
} from '../../../web/src/state/shaft-edits.ts';
import { SketchStore } from '../../../web/src/state/store.ts';
import { ShaftTool } from '../../../web/src/tools/shaft-tool.ts';
import type { PlaneMode, ToolContext } from '../../../web/src/tools/tool.ts';
import { readRatio } from '../../../web/src/ui/drive-field.tsx';
import { text } from '../../../web/src/ui/text.ts';
import { flatView, pointerOver } from '../helpers/flat-view.ts';

function begin() {
  const store = new SketchStore();
  const context: ToolContext = {
    store,
    view: flatView(store),
    joint: signal(null),
    plane: signal<PlaneMode>('auto'),
    nextPlane: () => undefined,
    announce: () => undefined,
    words: text,
  };
  const tool = new ShaftTool(context);
  const click = (x: number, y: number) => {
    const at = pointerOver([x, y, 0]);
    tool.pointerMove(at);
    tool.pointerDown(at);
    tool.pointerUp(at);
  };
  return { store, click };
}

/** Two shafts, side by side. */
function two() {
  const { store, click } = begin();
  click(0, 0);
  click(0, 5);
  click(3, 0);
  click(3, 5);
  return store;
}

describe('shaft tool', () => {
  it('draws a shaft from click to click and begins a new one with the third', () => {
    const { sketch } = two();
    expect(sketch.value.shafts).toEqual([
      { from: [0, 0, 0], to: [0, 5, 0] },
      { from: [3, 0, 0], to: [3, 5, 0] },
    ]);
    expect(sketch.value.version).toBe(2);
  });

  it('takes no slanted shaft and none that is longer than an axle', () => {
    expect(isLegalShaft([0, 0, 0], [0, 11, 0])).toBe(true);
    expect(isLegalShaft([0, 0, 0], [0, 12, 0])).toBe(false);
    expect(isLegalShaft([0, 0, 0], [3, 4, 0])).toBe(false);
    expect(isLegalShaft([0.5, 0, 0], [0.5, 4, 0])).toBe(false);
  });

  it('is undone step by step', () => {
    const store = two();
    store.undo();
    expect(store.sketch.value.shafts).toHaveLength(1);
    store.undo();
    expect(store.sketch.value.shafts).toBeUndefined();
    expect(store.sketch.value.version).toBe(1);
  });
});

describe('a drive', () => {
  it('couples the two shafts drawn last, and takes the place of one between them', () => {
    const { sketch } = two();
    const pair = lastPair(sketch.value);
    expect(pair).toEqual({ from: 0, to: 1 });
    const once = couple(sketch.value, { from: 0, to: 1, ratio: 3 });
    const twice = couple(once, { from: 1, to: 0, ratio: 5 });
    expect(twice.drives).toEqual([{ from: 1, to: 0, ratio: 5 }]);
  });

  it('goes with the shafts', () => {
    const { sketch } = two();
    const cleared = clearShafts(couple(sketch.value, { from: 0, to: 1, ratio: 3 }));
    expect(cleared.shafts ?? cleared.drives).toBeUndefined();
    expect(cleared.version).toBe(1);
  });

  it.each([
    ['5', 5],
    ['1,5', 1.5],
    ['5:3', 5 / 3],
    ['', null],
    ['0', null],
    ['3:0', null],
    ['1:2:3', null],
    ['x', null],
  ])('reads the ratio %s', (typed, ratio) => {
    expect(readRatio(typed)).toBe(ratio);
  });
});

describe('the ends of the last shaft', () => {
  const lines = [{ from: [0, 0, 0], to: [6, 0, 0] }] as const;
  const sketch = {
    format: 'technic-sketch',
    version: 2,
    name: '',
    lines,
    shafts: [
      { from: [1, -1, 0], to: [1, 4, 0] },
      { from: [4, -1, 0], to: [4, 4, 0] },
    ],
  } as const;

  it('take a crank and a wheel', () => {
    const cranked = withEnds(sketch, { atFrom: 'crank' });
    const both = withEnds(cranked, { atTo: 'wheel' });
    expect(both.shafts).toEqual([
      sketch.shafts[0],
      { ...sketch.shafts[1], atFrom: 'crank', atTo: 'wheel' },
    ]);
  });

  it('are bare again', () => {
    const cranked = withEnds(sketch, { atFrom: 'crank' });
    expect(withEnds(cranked, { atFrom: null }).shafts).toEqual(sketch.shafts);
  });
});
