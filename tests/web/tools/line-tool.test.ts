import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import { lineLength } from '../../../web/src/model/sketch.ts';
import { SketchStore } from '../../../web/src/state/store.ts';
import { nextPlaneMode } from '../../../web/src/tools/guide.ts';
import { LineTool } from '../../../web/src/tools/line-tool.ts';
import type { PlaneMode, ToolContext } from '../../../web/src/tools/tool.ts';
import { text } from '../../../web/src/ui/text.ts';
import { flatView, pointerOver } from '../helpers/flat-view.ts';

function begin() {
  const store = new SketchStore();
  const said: string[] = [];
  const plane = signal<PlaneMode>('auto');
  const context: ToolContext = {
    store,
    view: flatView(store),
    joint: signal(null),
    plane,
    nextPlane: () => {
      plane.value = nextPlaneMode(plane.value);
    },
    announce: (message) => said.push(message),
    words: text,
  };
  const tool = new LineTool(context);
  const click = (x: number, y: number) => {
    const at = pointerOver([x, y, 0]);
    tool.pointerMove(at);
    tool.pointerDown(at);
    tool.pointerUp(at);
  };
  const press = (...keys: string[]) => {
    for (const key of keys) tool.key({ key, shift: false });
  };
  return { store, tool, said, click, press, plane };
}

describe('line tool', () => {
  it('draws from click to click and goes on from the end', () => {
    const { store, click } = begin();
    click(0, 0);
    click(6.2, 0.1);
    click(6, 4.1);
    expect(store.sketch.value.lines).toEqual([
      { from: [0, 0, 0], to: [6, 0, 0] },
      { from: [6, 0, 0], to: [6, 4, 0] },
    ]);
  });

  it('draws whole lengths only, wherever the pointer is', () => {
    const { store, click, tool } = begin();
    for (let i = 0; i < 60; i++) {
      click(((i * 37) % 23) - 11 + 0.31, ((i * 53) % 19) - 9 + 0.17);
      if (i % 7 === 6) tool.escape();
    }
    expect(store.sketch.value.lines.length).toBeGreaterThan(20);
    for (const line of store.sketch.value.lines) {
      expect(Math.abs(lineLength(line) - Math.round(lineLength(line)))).toBeLessThan(1e-3);
    }
  });

  it('ends the chain where it began', () => {
    const { store, click, tool } = begin();
    for (const [x, y] of [
      [0, 0],
      [4, 0],
      [4, 4],
      [0, 4],
      [0, 0],
    ] as const) {
      click(x, y);
    }
    expect(store.sketch.value.lines).toHaveLength(4);
    expect(tool.escape()).toBe(false);
  });

  it('draws with one drag', () => {
    const { store, tool } = begin();
    tool.pointerMove(pointerOver([0, 0, 0]));
    tool.pointerDown(pointerOver([0, 0, 0]));
    tool.pointerMove(pointerOver([5, 0, 0]));
    tool.pointerUp(pointerOver([5, 0, 0]));
    expect(store.sketch.value.lines).toEqual([{ from: [0, 0, 0], to: [5, 0, 0] }]);
  });

  it('drops the point that a finger has begun when a second one comes', () => {
    const { tool, store } = begin();
    tool.pointerDown(pointerOver([0, 0, 0]));
    tool.pointerLeave();
    tool.pointerUp(pointerOver([5, 0, 0]));
    expect(tool.escape()).toBe(false);
    expect(store.sketch.value.lines).toHaveLength(0);
  });

  it('takes a typed length in the direction of the pointer', () => {
    const { store, click, tool, press } = begin();
    click(0, 0);
    tool.pointerMove(pointerOver([3, 0, 0]));
    press('1', '2', 'Enter');
    expect(store.sketch.value.lines[0]?.to).toEqual([12, 0, 0]);
  });

  it('keeps to a locked axis', () => {
    const { store, click, tool, press } = begin();
    click(0, 0);
    press('y');
    tool.pointerMove(pointerOver([7, 5, 0]));
    press('Enter');
    expect(store.sketch.value.lines[0]?.to).toEqual([0, 5, 0]);
  });

  it('steps back one thing at a time', () => {
    const { click, press, tool } = begin();
    click(0, 0);
    press('x', '9');
    expect(tool.escape()).toBe(true);
    expect(tool.overlay.value).toMatchObject({ typed: '', lock: null });
    expect(tool.escape()).toBe(true);
    expect(tool.escape()).toBe(false);
  });

  it('is drawn with by the keyboard alone', () => {
    const { store, press, said } = begin();
    press('Enter', 'ArrowRight', 'ArrowRight', 'ArrowRight', 'Enter');
    press('PageUp', 'PageUp', 'Enter');
    expect(store.sketch.value.lines).toEqual([
      { from: [0, 0, 0], to: [3, 0, 0] },
      { from: [3, 0, 0], to: [3, 0, 2] },
    ]);
    expect(said).toContain('Cursor 3, 0, 2');
  });

  it('says why a line cannot end at the cursor', () => {
    const { store, press, said } = begin();
    press('Enter', 'ArrowRight', 'ArrowUp', 'Enter');
    expect(store.sketch.value.lines).toHaveLength(0);
    expect(said.at(-1)).toBe(text.draw.noWholeLength);
  });

  it('turns the plane with Tab only while a line is begun', () => {
    const { tool, press, plane } = begin();
    expect(tool.key({ key: 'Tab', shift: false })).toBe(false);
    press('Enter', 'Tab');
    expect(plane.value).toBe('z');
  });
});
