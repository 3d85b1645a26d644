import { afterAll, beforeAll, expect, test } from 'vitest';
import { openBrowserSolver } from '../../scripts/lib/browser-solver.mjs';
import { exampleText, loadModule, solveWithCommand, solveWithModule } from './module.ts';

// One search in three places: the command, the module in Node and the module in Chromium.
const DRAWINGS = [
  'airplane',
  'box-shelf',
  'bridge',
  'cart',
  'chair',
  'grid',
  'house',
  'seesaw',
  'tower',
  'windmill',
];
const SEED = 2;

let inNode;
let browser;

beforeAll(async () => {
  [inNode, browser] = await Promise.all([loadModule(), openBrowserSolver()]);
});

afterAll(() => browser?.close());

test.each(DRAWINGS)('%s: command, Node and Chromium write the same model bytes', async (name) => {
  const sketch = exampleText(name);
  const native = solveWithCommand(name, ['--seed', `${SEED}`]).modelJson.trimEnd();
  expect(JSON.parse(native).parts.length).toBeGreaterThan(5);
  const { model } = await browser.solve(sketch, { seed: SEED });
  expect(model.trimEnd()).toBe(native);
  expect(solveWithModule(inNode, sketch, { seed: SEED }).modelJson.trimEnd()).toBe(native);
});
