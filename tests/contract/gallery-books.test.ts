import { existsSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import { readPlan } from '../../web/src/instructions/assembly-plan.ts';
import { buildSteps, replayFaults, timesOf } from '../../web/src/instructions/build-steps.ts';
import type { Model } from '../../web/src/model/model.ts';
import type { SolverModule } from '../../web/src/solver/solver-module.ts';
import { readGearTrain, withTrain } from '../../web/src/ui/gallery/gear-train.ts';
import { catalogue } from '../web/view/helpers/catalogue.ts';
import {
  type GalleryTestRow,
  modelOf,
  galleryRows as models,
  galleryText as text,
} from './gallery-rows.ts';
import { loadModule } from './module.ts';

// What a person takes from the gallery to the table: steps to build by, and files for other programs.

const TOP = resolve(import.meta.dirname, '../..');
const LDRAW = resolve(TOP, '../shared/ldraw');

let module: SolverModule;

beforeAll(async () => {
  module = await loadModule();
});

/** Solved once for all tests. */
const known = new Map<string, string>();

function wholeModel(row: GalleryTestRow): string {
  const model = known.get(row.file) ?? solveWhole(row);
  known.set(row.file, model);
  return model;
}

/** The model of a row as one builds it: with its gears where it has some. */
function solveWhole(row: GalleryTestRow): string {
  const modelJson = modelOf(row, module);
  if (!row.gears) {
    return modelJson;
  }
  const train = readGearTrain(JSON.parse(text(row.gears)), catalogue);
  if (!train.ok) {
    throw new Error(train.message);
  }
  return withTrain(modelJson, train.value, catalogue);
}

function exported(model: string, format: string): string {
  const reply = module.exportModel(model, format);
  expect(reply.status, reply.text).toBe('ok');
  return reply.text;
}

describe.each(models)('$id', (row) => {
  it('is built by its steps: each part once, no step impossible', () => {
    const json = wholeModel(row);
    const model = JSON.parse(json) as Model;
    const plan = readPlan(exported(json, 'assembly.json'), model.parts.length);
    if (!plan.ok) {
      throw new Error(plan.message);
    }
    expect(replayFaults(plan.value, model.parts.length)).toEqual([]);
    const steps = buildSteps(plan.value, model);
    // A parts box shows what one of the repeated subassemblies takes.
    const boxes = steps.flatMap(({ group, loose }) =>
      loose.map(({ count }) => count * timesOf(group)),
    );
    expect(boxes.reduce((sum, count) => sum + count, 0)).toBe(model.parts.length);
    expect(steps.flatMap((step) => step.adds).filter((add) => add.forced)).toEqual([]);
  }, 180_000);

  it.skipIf(!existsSync(LDRAW))(
    'names only parts and colours that LDraw has',
    () => {
      const known = readFileSync(resolve(LDRAW, 'LDConfig.ldr'), 'utf8');
      const colours = new Set(
        [...known.matchAll(/^0 !COLOUR \S+\s+CODE\s+(\d+)/gm)].map((m) => m[1]),
      );
      const json = wholeModel(row);
      const lines = exported(json, 'mpd').split(/\r?\n/);
      const placed = lines.map((line) => line.split(/\s+/)).filter(([kind]) => kind === '1');
      const parts = placed.filter((fields) => fields.at(-1)?.endsWith('.dat'));
      expect(parts.length).toBeGreaterThan(0);
      expect(parts.filter(([, colour = '']) => !colours.has(colour))).toEqual([]);
      const files = new Set(parts.map((fields) => fields.at(-1) ?? ''));
      expect([...files].filter((file) => !existsSync(resolve(LDRAW, 'parts', file)))).toEqual([]);
    },
    180_000,
  );
});
