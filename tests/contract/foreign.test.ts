import { beforeAll, describe, expect, it } from 'vitest';
import { readModel } from '../../web/src/app/read-model.ts';
import { parseFile } from '../../web/src/app/reading/parse-file.ts';
import { readPlan } from '../../web/src/instructions/assembly-plan.ts';
import { buildSteps, replayFaults } from '../../web/src/instructions/build-steps.ts';
import { withGuestsLast } from '../../web/src/instructions/guest-steps.ts';
import { withGuestsAsParts } from '../../web/src/model/guests.ts';
import type { Model } from '../../web/src/model/model.ts';
import type { SolverModule } from '../../web/src/solver/solver-module.ts';
import { catalogue } from '../web/view/helpers/catalogue.ts';
import { FOREIGN, foreignText } from './foreign-models.ts';
import { galleryRows, modelOf } from './gallery-rows.ts';
import { loadModule } from './module.ts';

// Models of other people's programs, of 100 to 600 parts: they open, what is known of them is judged as the same model of
// ours, and they get steps and a parts list of all their parts.

let module: SolverModule;

beforeAll(async () => {
  module = await loadModule();
});

function modelIn(json: string): Model {
  const model = readModel(json);
  if (!model.ok) {
    throw new Error(model.message);
  }
  return model.value;
}

describe.each(FOREIGN)('a file with the habits of others: $id', (habits) => {
  const row = galleryRows.find(({ id }) => id === habits.id);
  const strange = Object.values(habits.guests ?? {}).reduce((sum, n) => sum + n, 0);

  it('is opened, judged as what it is, and gets steps for all its parts', () => {
    if (!row) {
      throw new Error(`${habits.id} is not in the gallery`);
    }
    const ours = modelIn(modelOf(row, module));
    const opened = parseFile(foreignText(ours.parts, habits), catalogue.parts, 'Mine.mpd');
    const file = opened.ok && opened.value.kind === 'model' ? opened.value : null;
    expect(opened.ok ? '' : opened.message).toBe('');
    const json = file?.json ?? '';
    const model = modelIn(json);

    expect(model.name).toBe('Mine');
    expect(model.guests?.count ?? 0).toBe(strange);
    expect(model.parts).toHaveLength(ours.parts.length + strange);
    expect(model.parts.length).toBeGreaterThanOrEqual(100);
    expect(model.parts.length).toBeLessThanOrEqual(600);
    for (const [id, count] of Object.entries(habits.guests ?? {})) {
      expect(file?.notes.join()).toContain(`${id} (${count})`);
    }

    const check: unknown = JSON.parse(module.checkModelJson(json).text);
    expect(check).toMatchObject({ buildable: true, problems: [] });

    const known = model.parts.length - strange;
    const plan = readPlan(module.exportModel(json, 'assembly.json').text, known);
    const whole = withGuestsLast(
      plan.ok ? plan.value : { groups: [], steps: [], assemblable: false, stuck: [] },
      model,
    );
    expect(replayFaults(whole, model.parts.length)).toEqual([]);
    const steps = buildSteps(whole, model);
    expect(steps.flatMap(({ adds }) => adds).every(({ forced }) => !forced)).toBe(true);

    const list = module.exportModel(withGuestsAsParts(json), 'parts.csv').text.split(/\r?\n/);
    const counted = list.slice(1).reduce((sum, line) => sum + Number(line.split(',')[2] ?? 0), 0);
    expect(counted).toBe(model.parts.length);
  }, 180_000);
});
