import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../../web/src/geometry/vec.ts';
import type { SketchLine } from '../../../web/src/model/sketch.ts';
import type { JointPlace } from '../../../web/src/state/joint-edits.ts';
import { SketchStore } from '../../../web/src/state/store.ts';
import { JointTool } from '../../../web/src/tools/joint-tool.ts';
import { text } from '../../../web/src/ui/text.ts';
import { frameOf, handlePlaces, ringRadius } from '../../../web/src/view/joint-ring.ts';
import { flatView, pointerOver } from '../helpers/flat-view.ts';

const LINES: readonly SketchLine[] = [
  { from: [0, 0, 0], to: [8, 0, 0] },
  { from: [0, 0, 0], to: [0, 8, 0] },
  { from: [-8, 0, 0], to: [0, 0, 0] },
];

function begin() {
  const store = new SketchStore();
  store.commit('draw', { format: 'technic-sketch', version: 1, lines: LINES });
  const joint = signal<JointPlace | null>(null);
  const view = flatView(store);
  const tool = new JointTool({
    store,
    view,
    joint,
    plane: signal('auto' as const),
    nextPlane: () => undefined,
    announce: () => undefined,
    words: text,
  });
  const press = (from: Vec3, ...way: readonly Vec3[]) => {
    tool.pointerMove(pointerOver(from));
    tool.pointerDown(pointerOver(from));
    for (const to of way) {
      tool.pointerMove(pointerOver(to));
    }
    tool.pointerUp(pointerOver(way.at(-1) ?? from));
  };
  const only = () => {
    const [first] = store.sketch.value.joints ?? [];
    if (!first) {
      throw new Error('there is no joint');
    }
    return first;
  };
  const handle = (name: 'from' | 'to') =>
    handlePlaces(
      frameOf(store.sketch.value, only()),
      only().range,
      ringRadius(view.pixelsPerModule()),
    )[name];
  return { store, joint, tool, press, only, handle };
}

const key = (name: string) => ({ key: name, shift: false });

describe('a click', () => {
  it('at a junction sets a joint and chooses it', () => {
    const { press, only, joint } = begin();
    press([0, 0, 0]);
    expect(only()).toEqual({ at: [0, 0, 0], axis: [0, 0, 1], between: [[0, 2], [1]] });
    expect(joint.value).toEqual({ at: [0, 0, 0], nth: 0 });
  });

  it('at a joint that is there chooses it and changes nothing', () => {
    const { press, store, joint } = begin();
    press([0, 0, 0]);
    joint.value = null;
    const before = store.sketch.value;
    press([0, 0, 0]);
    expect(store.sketch.value).toBe(before);
    expect(joint.value).toEqual({ at: [0, 0, 0], nth: 0 });
  });

  it('on a line of the joint changes its side', () => {
    const { press, only } = begin();
    press([0, 0, 0]);
    press([6, 0, 0]);
    expect(only().between).toEqual([[2], [0, 1]]);
  });
});

describe('the ends of the range', () => {
  it('are dragged in steps of five degrees, one step of the history', () => {
    const { press, only, handle, store } = begin();
    press([0, 0, 0]);
    press(handle('to'), [-3, 0.05, 0]);
    expect(only().range).toEqual([0, 90]);
    press(handle('from'), [3, 3.1, 0]);
    expect(only().range).toEqual([-45, 90]);
    store.undo();
    expect(only().range).toEqual([0, 90]);
  });

  it('become a half turn near it', () => {
    const { press, only, handle } = begin();
    press([0, 0, 0]);
    press(handle('to'), [-3, 0, 0], [-2, -2.2, 0], [0.1, -3, 0]);
    expect(only().range).toEqual([0, 180]);
  });

  it('go back when the camera takes the press', () => {
    const { press, only, handle, tool } = begin();
    press([0, 0, 0]);
    const at = pointerOver(handle('to'));
    tool.pointerDown(at);
    tool.pointerMove(pointerOver([-3, 0.05, 0]));
    tool.pointerLeave();
    expect(only().range).toBeUndefined();
  });
});

describe('keys', () => {
  it('set the axis', () => {
    const { press, only, tool } = begin();
    press([0, 0, 0]);
    expect(tool.key(key('x'))).toBe(true);
    expect(only().axis).toEqual([1, 0, 0]);
  });

  it('change the side of a line by its number', () => {
    const { press, only, tool } = begin();
    press([0, 0, 0]);
    tool.key(key('1'));
    expect(only().between).toEqual([[2], [0, 1]]);
  });

  it('delete the joint that is chosen', () => {
    const { press, store, tool } = begin();
    press([0, 0, 0]);
    tool.key(key('Delete'));
    expect(store.sketch.value.joints).toBeUndefined();
  });

  it('let go of the joint before the tool is left', () => {
    const { press, joint, tool } = begin();
    press([0, 0, 0]);
    expect(tool.escape()).toBe(true);
    expect(joint.value).toBeNull();
    expect(tool.escape()).toBe(false);
  });
});

describe('several joints at one node', () => {
  it('a further click goes to the next one, though the ends of the axis lie over it', () => {
    const { press, joint, store } = begin();
    press([0, 0, 0]);
    const sketch = store.sketch.value;
    store.commit('add', {
      ...sketch,
      joints: [...(sketch.joints ?? []), ...(sketch.joints ?? [])],
    });
    press([0, 0, 0]);
    expect(joint.value?.nth).toBe(1);
    press([0, 0, 0]);
    expect(joint.value?.nth).toBe(0);
  });
});
