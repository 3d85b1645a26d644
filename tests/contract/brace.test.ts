import { expect, test } from 'vitest';
import { readMotionAnswer } from '../../web/src/model/motion.ts';
import type { SketchDocument } from '../../web/src/model/sketch.ts';
import type { SolverModule } from '../../web/src/solver/solver-module.ts';
import { addLines } from '../../web/src/state/edits.ts';
import { readSketch, writeSketch } from '../../web/src/state/read-sketch.ts';
import { exampleText, loadModule, solveWithModule } from './module.ts';

function exampleSketch(name: string): SketchDocument {
  const read = readSketch(exampleText(name));
  if (!read.ok) {
    throw new Error(`${name} cannot be read`);
  }
  return read.value;
}

function solved(module: SolverModule, sketch: SketchDocument) {
  const { modelJson, report } = solveWithModule(module, writeSketch(sketch), {
    seed: 1,
    preset: 'simple',
  });
  const { status, text } = module.analyseMotionJson(modelJson);
  expect(status).toBe('ok');
  return { report, motion: readMotionAnswer(text) };
}

test('the brace that is offered for a loose square makes it rigid once it is added', async () => {
  const module = await loadModule();
  const square = exampleSketch('square-frame');
  const loose = solved(module, square).motion;
  expect(loose.freedoms.beyondJoints).toBeGreaterThan(0);

  const braced = addLines(
    square,
    loose.braces.map(({ from, to }) => ({ from, to })),
  );
  expect(braced.lines.length).toBeGreaterThan(square.lines.length);
  const { report, motion } = solved(module, braced);
  expect(report['buildable']).toBe(true);
  expect(motion.freedoms.beyondJoints).toBe(0);
});
