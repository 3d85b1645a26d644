import { expect, test } from 'vitest';
import { exampleText, loadModule, solveWithCommand, solveWithModule } from './module.ts';

// Small drawings: lattice, off-lattice and several planes.
const DRAWINGS = ['square-frame', 'cube', 'hexagon', 'house', 'letter-a'] as const;

const module = await loadModule();

test.each(DRAWINGS)('%s: the module and the command write the same model bytes', (name) => {
  const native = solveWithCommand(name, ['--seed', '3']);
  const wasm = solveWithModule(module, exampleText(name), { seed: 3 });
  expect(wasm.modelJson.trimEnd()).toBe(native.modelJson.trimEnd());
});

test.each(DRAWINGS)('%s: the reports agree but for the times', (name) => {
  const { seconds: _, ...native } = solveWithCommand(name, ['--seed', '3']).report;
  const { seconds: __, ...wasm } = solveWithModule(module, exampleText(name), { seed: 3 }).report;
  expect(wasm).toEqual(native);
});

test('a table that is to be stiff is the same in both, and stiff', () => {
  const settings = { seed: 1, preset: 'simple-rigid' };
  const native = solveWithCommand('table', ['--seed', '1', '--preset', 'simple-rigid']);
  const wasm = solveWithModule(module, exampleText('table'), settings);
  expect(wasm.modelJson.trimEnd()).toBe(native.modelJson.trimEnd());
  expect(native.report['freedoms']).toBe(0);
  expect(native.report['buildable']).toBe(true);
});

test('a model with frames is the same in both', () => {
  const native = solveWithCommand('cart', ['--seed', '1']);
  const wasm = solveWithModule(module, exampleText('cart'), { seed: 1 });
  expect(wasm.modelJson.trimEnd()).toBe(native.modelJson.trimEnd());
  const parts = (JSON.parse(wasm.modelJson) as { parts: { part: string }[] }).parts;
  expect(parts.some(({ part }) => ['14720', '64178', '64179'].includes(part))).toBe(true);
  expect(native.report['buildable']).toBe(true);
});

test('a model with lines that axles cover is the same in both', () => {
  const native = solveWithCommand('letter-a', ['--seed', '1']);
  const wasm = solveWithModule(module, exampleText('letter-a'), { seed: 1 });
  expect(wasm.modelJson.trimEnd()).toBe(native.modelJson.trimEnd());
  expect(native.report['axles']).toBeGreaterThan(0);
  expect(native.report['buildable']).toBe(true);
});

test('the slices of the work do not change the model', () => {
  const sketch = exampleText('house');
  const fine = solveWithModule(module, sketch, { seed: 5 }, 7);
  const coarse = solveWithModule(module, sketch, { seed: 5 }, 1 << 30);
  expect(fine.modelJson).toBe(coarse.modelJson);
});

test('asking for progress and models on the way does not change the model', () => {
  const sketch = exampleText('cube');
  const session = new module.SolverSession(sketch, '{"seed":5}');
  while (!session.advance(50)) {
    session.progressJson();
    session.modelJson();
    session.reportJson();
  }
  const watched = session.modelJson();
  session.delete();
  expect(watched).toBe(solveWithModule(module, sketch, { seed: 5 }).modelJson);
});

test('two sessions that take turns do not disturb each other', () => {
  const open = (name: string) => new module.SolverSession(exampleText(name), '{"seed":2}');
  const [a, b] = [open('house'), open('cube')];
  let [aDone, bDone] = [false, false];
  while (!aDone || !bDone) {
    aDone = aDone || a.advance(100);
    bDone = bDone || b.advance(100);
  }
  const alone = (name: string) => solveWithModule(module, exampleText(name), { seed: 2 }).modelJson;
  expect([a.modelJson(), b.modelJson()]).toEqual([alone('house'), alone('cube')]);
  a.delete();
  b.delete();
});
