// The laboratory's module is the page's with the rivals, and gives what the command gives.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import createLiftarmLab from '@wasm/liftarm-lab.js';
import { beforeAll, describe, expect, it } from 'vitest';
import {
  cubeSketch as familyCube,
  gridSketch as familyGrid,
} from '../../scripts/lib/families/families.mjs';
import type { SolverModule } from '../../web/src/solver/solver-module.ts';
import { parseAdvanced } from '../../web/src/state/preferences.ts';
import { cubeSketch, gridSketch } from '../../web/src/ui/laboratory/lab-sketches.ts';
import {
  NO_TURNS,
  proposalCandidates,
  weightsText,
} from '../../web/src/ui/laboratory/proposals.ts';
import { FIRST_PLAN, METHODS, settingsOfRun } from '../../web/src/ui/laboratory/race-plan.ts';
import { exampleText, loadModule, solveWithCommand, solveWithModule } from './module.ts';

const WASM = resolve(import.meta.dirname, '../../build/wasm/liftarm-lab.wasm');
const EXAMPLE = 'square-frame';

describe('the module of the laboratory', () => {
  let lab: SolverModule;
  beforeAll(async () => {
    lab = await createLiftarmLab({ wasmBinary: readFileSync(WASM), printErr: () => {} });
  });

  it.each(METHODS)('gives the model of the command, byte for byte: %s', (method) => {
    const settings = settingsOfRun(FIRST_PLAN, method);
    const pairs = Object.entries(settings.set ?? {}).map(([key, value]) => `${key}=${value}`);
    const flags = ['--preset', 'simple', '--method', method, '--seed', `${settings.seed}`];
    const ours = solveWithModule(lab, exampleText(EXAMPLE), settings);
    const its = solveWithCommand(EXAMPLE, [...flags, ...pairs.flatMap((pair) => ['--set', pair])]);
    expect(ours.modelJson.trim()).toBe(its.modelJson.trim());
    expect(ours.report['method']).toBe(method);
  });

  it('has methods that the page’s module refuses', async () => {
    const page = await loadModule();
    const settings = JSON.stringify(settingsOfRun(FIRST_PLAN, 'greedy'));
    const session = new page.SolverSession(exampleText(EXAMPLE), settings);
    expect(session.opened().status).toBe('invalidInput');
    session.delete();
  });
});

describe('what the laboratory asks of the page’s module', () => {
  it.each(proposalCandidates(1))(
    'is a search that it knows: proposal $id',
    async ({ id, preset }) => {
      const page = await loadModule();
      const settings = { preset, set: parseAdvanced(weightsText(id, NO_TURNS)) };
      const { report } = solveWithModule(page, exampleText(EXAMPLE), settings);
      expect(report['buildable']).toBe(true);
    },
  );
});

describe('grids and cubes', () => {
  it.each([1, 4, 10])('are those of the experiments: %i', (n) => {
    expect(gridSketch(n)).toEqual(familyGrid(n));
    expect(cubeSketch(n)).toEqual(familyCube(n));
  });
});
