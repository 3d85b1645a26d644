import { beforeAll, describe, expect, it } from 'vitest';
import { readModel } from '../../web/src/app/read-model.ts';
import { findMend, type Mend } from '../../web/src/model/mends.ts';
import type { CheckReport, Problem } from '../../web/src/model/report.ts';
import { readMpd } from '../../web/src/share/read-mpd.ts';
import type { SolverModule } from '../../web/src/solver/solver-module.ts';
import { catalogue } from '../web/view/helpers/catalogue.ts';
import { loadModule } from './module.ts';

let module: SolverModule;

beforeAll(async () => {
  module = await loadModule();
});

function problemsOf(json: string): readonly Problem[] {
  return (JSON.parse(module.checkModelJson(json).text) as CheckReport).problems;
}

async function mendOf(rows: readonly string[]): Promise<{ json: string; mend: Mend | null }> {
  const json = readMpd(rows.join('\n'), catalogue);
  const text = json.ok ? json.value : '';
  const model = readModel(text);
  if (!model.ok) {
    throw new Error(model.message);
  }
  const ask = (file: string) => Promise.resolve(problemsOf(file));
  const problems = problemsOf(text);
  return {
    json: text,
    mend: await findMend({ json: text, model: model.value, problems, catalogue, ask }),
  };
}

const beam = (height: number) => `1 71 0 ${height} 0 1 0 0 0 1 0 0 0 1 32316.dat`;
const pin = (height: number, at: number, part = '2780') =>
  `1 0 0 ${height} ${at} 0 -1 0 1 0 0 0 0 1 ${part}.dat`;

describe('mends of a model from a file', () => {
  it('are none where nothing is wrong', async () => {
    const { json, mend } = await mendOf([beam(0), beam(-20), pin(-10, 0), pin(-10, 40)]);
    expect(problemsOf(json)).toEqual([]);
    expect(mend).toBeNull();
  });

  it('put an axle pin where a round pin sits in a cross hole', async () => {
    const cross = '1 71 0 0 0 1 0 0 0 1 0 0 0 1 60483.dat';
    const { mend } = await mendOf([cross, beam(-20), pin(-10, 0)]);
    expect(mend).toMatchObject({ before: '2780', after: '43093', left: 0 });
    expect(problemsOf(mend?.json ?? '')).toEqual([]);
  });

  it('put a pin of three where one of two leaves a beam out', async () => {
    const rows = [beam(0), beam(-20), beam(-40), pin(-10, 0), pin(-10, 40)];
    const { json, mend } = await mendOf(rows);
    expect(problemsOf(json)).not.toEqual([]);
    expect(mend).toMatchObject({ before: '2780', after: '6558', left: 0 });
  });

  it('are none where no pin helps', async () => {
    const far = '1 71 200 0 0 1 0 0 0 1 0 0 0 1 32316.dat';
    expect((await mendOf([beam(0), beam(-20), pin(-10, 0), far])).mend).toBeNull();
  });
});
