import { beforeAll, expect, test } from 'vitest';
import type { Vec3 } from '../../../web/src/geometry/vec.ts';
import { isSameSymmetry, readFoundSymmetries } from '../../../web/src/model/found-symmetries.ts';
import type { SketchDocument, SketchLine } from '../../../web/src/model/sketch.ts';
import type { SolverModule } from '../../../web/src/solver/solver-module.ts';
import { loadModule } from '../../contract/module.ts';

const line = (from: Vec3, to: Vec3): SketchLine => ({ from, to });
const frame = (x: number): SketchLine[] => [
  line([x, 0, 0], [x, 8, 0]),
  line([x, 0, 0], [x, 0, 4]),
  line([x, 8, 0], [x, 8, 4]),
];

let module: SolverModule;
beforeAll(async () => {
  module = await loadModule();
});

function found(lines: readonly SketchLine[], more: Partial<SketchDocument> = {}) {
  const sketch = { format: 'technic-sketch', version: 1, lines, ...more };
  return readFoundSymmetries(module.findSymmetriesJson(JSON.stringify(sketch)).text);
}

test('two like frames side by side are mirrors of each other and one shifted', () => {
  const kinds = found([...frame(0), ...frame(6)]).map(({ kind }) => kind);
  expect(kinds.filter((kind) => kind === 'reflection').length).toBeGreaterThanOrEqual(2);
  expect(kinds).toContain('translation');
});

test('a square looks the same after a quarter turn', () => {
  const square = [
    line([0, 0, 0], [6, 0, 0]),
    line([6, 0, 0], [6, 6, 0]),
    line([6, 6, 0], [0, 6, 0]),
    line([0, 6, 0], [0, 0, 0]),
  ];
  expect(found(square)).toContainEqual(expect.objectContaining({ kind: 'rotation', order: 4 }));
});

test('what the sketch names already is not found again', () => {
  const lines = frame(0);
  const [first] = found(lines).filter((each) => each.kind === 'reflection');
  if (first?.kind !== 'reflection') {
    throw new Error('the frame has a mirror plane');
  }
  const rest = found(lines, { symmetries: [first] });
  expect(rest.some((each) => isSameSymmetry(each, first))).toBe(false);
});

test.each(['', 'null', '{"symmetries": 3}', '{"symmetries": [null, {"kind": "turn"}]}'])(
  'an answer of another form, %s, holds none',
  (answer) => {
    expect(readFoundSymmetries(answer)).toEqual([]);
  },
);
