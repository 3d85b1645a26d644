import { describe, expect, it } from 'vitest';
import type { SketchDocument, SketchLine } from '../../../web/src/model/sketch.ts';
import { connectedLines, joinLines } from '../../../web/src/state/connectivity.ts';
import {
  addLines,
  mapLine,
  mapLines,
  mirrorAt,
  quarterTurn,
  removeLines,
  setExact,
  setHoleAxis,
  shift,
  splitAt,
} from '../../../web/src/state/edits.ts';

const line = (from: SketchLine['from'], to: SketchLine['to']): SketchLine => ({ from, to });

const SKETCH: SketchDocument = {
  format: 'technic-sketch',
  version: 1,
  lines: [
    line([0, 0, 0], [6, 0, 0]),
    line([6, 0, 0], [6, 4, 0]),
    line([6, 4, 0], [6, 9, 0]),
    line([20, 0, 0], [20, 0, 3]),
  ],
  joints: [{ at: [6, 0, 0], axis: [0, 0, 1], between: [[0], [1, 2]] }],
  symmetries: [{ kind: 'translation', vector: [0, 4, 0], pairs: [[0, 3]] }],
};

describe('edits', () => {
  it('adds no line twice, whichever way round', () => {
    const next = addLines(SKETCH, [line([6, 0, 0], [0, 0, 0]), line([0, 0, 0], [0, 0, 0])]);
    expect(next).toBe(SKETCH);
  });

  it('lets joints and symmetries follow when lines are removed', () => {
    const next = removeLines(SKETCH, new Set([1]));
    expect(next.joints).toEqual([{ at: [6, 0, 0], axis: [0, 0, 1], between: [[0], [1]] }]);
    expect(next.symmetries?.[0]).toMatchObject({ pairs: [[0, 2]] });
  });

  it('drops a joint with nothing left on one side', () => {
    expect(removeLines(SKETCH, new Set([0])).joints).toBeUndefined();
  });

  it('takes a joint along when its lines are moved', () => {
    const moved = mapLines(SKETCH, new Set([0, 1, 2]), shift([1, 0, 2]));
    expect(moved.joints).toEqual([{ at: [7, 0, 2], axis: [0, 0, 1], between: [[0], [1, 2]] }]);
    const turned = mapLines(SKETCH, new Set([0, 1, 2, 3]), quarterTurn('x', [0, 0, 0]));
    expect(turned.joints).toMatchObject([{ at: [6, 0, 0], axis: [0, -1, 0] }]);
  });

  it('leaves a joint where others of its lines stay, and drops one whose lines part', () => {
    expect(mapLines(SKETCH, new Set([3]), shift([1, 0, 0])).joints).toEqual(SKETCH.joints);
    expect(mapLines(SKETCH, new Set([0]), shift([0, 0, 2]))).not.toHaveProperty('joints');
  });

  it('takes symmetries along when everything is moved', () => {
    const mirrored: SketchDocument = {
      ...SKETCH,
      symmetries: [
        ...(SKETCH.symmetries ?? []),
        { kind: 'reflection', normal: [1, 0, 0], offset: 3 },
      ],
    };
    const all = new Set(SKETCH.lines.keys());
    expect(mapLines(mirrored, all, quarterTurn('z', [0, 0, 0])).symmetries).toEqual([
      { kind: 'translation', vector: [-4, 0, 0], pairs: [[0, 3]] },
      { kind: 'reflection', normal: [0, 1, 0], offset: 3 },
    ]);
    expect(mapLines(mirrored, all, shift([2, 0, 0])).symmetries).toMatchObject([
      { vector: [0, 4, 0] },
      { normal: [1, 0, 0], offset: 5 },
    ]);
  });

  it('is itself again after four quarter turns', () => {
    const turn = quarterTurn('y', [1, 2, 3]);
    const start: SketchLine = { from: [0, 0, 0], to: [3, 0, 4], holeAxis: 'x' };
    let turned = start;
    for (let i = 0; i < 4; i++) {
      turned = mapLine(turned, turn);
    }
    expect(turned).toEqual(start);
    expect(mapLine(start, turn).holeAxis).toBe('z');
  });

  it('is itself again after two reflections', () => {
    const start = line([1, 2, 3], [1, 6, 6]);
    const mirror = mirrorAt('y', 2.5);
    expect(mapLine(mapLine(start, mirror), mirror)).toEqual(start);
  });

  it('splits at a node and joins again', () => {
    const split = splitAt(SKETCH, 0, [2, 0, 0]);
    expect(split.lines).toHaveLength(5);
    const joined = joinLines(split, new Set([0, 4]));
    expect(joined.lines[0]).toEqual(SKETCH.lines[0]);
    expect(joined.lines).toHaveLength(4);
  });

  it('keeps a joint while two of its bodies are left', () => {
    const shared = {
      ...SKETCH,
      joints: [{ at: [6, 0, 0], axis: [0, 0, 1], between: [[0], [1], [2]] }],
    } satisfies SketchDocument;
    const one = removeLines(shared, new Set([1]));
    expect(one.joints).toEqual([{ at: [6, 0, 0], axis: [0, 0, 1], between: [[0], [1]] }]);
    expect(removeLines(shared, new Set([1, 2])).joints).toBeUndefined();
  });

  it('does not split between nodes', () => {
    expect(splitAt(SKETCH, 0, [2.5, 0, 0])).toBe(SKETCH);
  });

  it('does not join round a corner', () => {
    expect(joinLines(SKETCH, new Set([0, 1]))).toBe(SKETCH);
  });

  it('finds what hangs together', () => {
    expect([...connectedLines(SKETCH, new Set([2]))].sort()).toEqual([0, 1, 2]);
  });

  it('leaves no trace of an annotation that is taken back', () => {
    const all = new Set([0, 1, 2, 3]);
    const marked = setHoleAxis(setExact(SKETCH, all, true), all, 'z');
    expect(setHoleAxis(setExact(marked, all, false), all, null)).toEqual(SKETCH);
  });
});
