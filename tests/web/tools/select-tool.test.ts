import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../../web/src/geometry/vec.ts';
import type { SketchLine } from '../../../web/src/model/sketch.ts';
import { SketchStore } from '../../../web/src/state/store.ts';
import { SelectTool } from '../../../web/src/tools/select-tool.ts';
import { text } from '../../../web/src/ui/text.ts';
import { flatView, pointerOver } from '../helpers/flat-view.ts';

const chain = (...points: Vec3[]): SketchLine[] =>
  points.slice(1).map((to, i) => ({ from: points[i] ?? to, to }));

const FRAME = chain([0, 0, 0], [8, 0, 0], [8, 6, 0], [0, 6, 0], [0, 0, 0]);

function begin() {
  const store = new SketchStore();
  store.commit('draw', { format: 'technic-sketch', version: 1, lines: FRAME });
  const tool = new SelectTool({
    store,
    view: flatView(store),
    joint: signal(null),
    plane: signal('auto' as const),
    nextPlane: () => undefined,
    announce: () => undefined,
    words: text,
  });
  const drag = (from: Vec3, to: Vec3, alt = false) => {
    tool.pointerMove(pointerOver(from));
    tool.pointerDown(pointerOver(from));
    tool.pointerMove({ ...pointerOver(to), alt });
    const { label } = tool.overlay.value;
    tool.pointerUp({ ...pointerOver(to), alt });
    return label;
  };
  return { store, tool, drag, lines: () => store.sketch.value.lines };
}

describe('dragging an end', () => {
  it('stretches the frame, and says by how much and what follows', () => {
    const { drag, lines, tool } = begin();
    expect(tool.navigation(pointerOver([8, 0, 0]))).toBe('tool');
    const label = drag([8, 0, 0], [10.2, 0.1, 0]);
    expect(lines()).toEqual(chain([0, 0, 0], [10, 0, 0], [10, 6, 0], [0, 6, 0], [0, 0, 0]));
    expect(label).toMatchObject({ at: [10, 0, 0], main: 'X +2' });
    expect(label?.note).toContain('3');
  });

  it('is one step of the history', () => {
    const { drag, lines, store } = begin();
    drag([8, 6, 0], [9, 9, 0]);
    expect(lines()[1]?.to).toEqual([9, 9, 0]);
    store.undo();
    expect(lines()).toEqual(FRAME);
  });

  it('with Alt tears one line off', () => {
    const { drag, lines } = begin();
    drag([8, 0, 0], [11, 0, 0], true);
    expect(
      lines().filter((line, i) => line !== FRAME[i] && String(line.to) !== String(FRAME[i]?.to)),
    ).toHaveLength(1);
  });

  it('leaves the camera to what begins elsewhere', () => {
    const { tool } = begin();
    expect(tool.navigation(pointerOver([4, 3, 0]))).toBe('orbit');
  });
});

describe('dragging a selection', () => {
  it('stretches what is joined to it', () => {
    const { drag, lines, store } = begin();
    store.select([1]);
    drag([8, 2, 0], [9, 2, 0]);
    expect(lines()).toEqual(chain([0, 0, 0], [9, 0, 0], [9, 6, 0], [0, 6, 0], [0, 0, 0]));
  });

  it('with Alt takes it away from there', () => {
    const { drag, lines, store } = begin();
    store.select([1]);
    drag([8, 2, 0], [9, 2, 0], true);
    expect(lines()[1]).toEqual({ from: [9, 0, 0], to: [9, 6, 0] });
    expect(lines()[0]).toEqual(FRAME[0]);
  });
});
