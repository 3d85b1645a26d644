import { beforeAll, describe, expect, test } from 'vitest';
import { readStressAnswer, type StressAnswer } from '../../web/src/model/stress.ts';
import type { SolverModule } from '../../web/src/solver/solver-module.ts';
import { exampleText, loadModule, solveWithModule } from './module.ts';

describe('the stress of a solved drawing', () => {
  let module: SolverModule;
  let modelJson = '';

  beforeAll(async () => {
    module = await loadModule();
    modelJson = solveWithModule(module, exampleText('square-frame'), {
      seed: 1,
      preset: 'simple',
    }).modelJson;
  });

  const answerTo = (options: object): StressAnswer => {
    const { status, text } = module.analyseStressJson(modelJson, JSON.stringify(options));
    expect(status).toBe('ok');
    return readStressAnswer(text);
  };

  test('has the fields that the page reads', () => {
    const answer = answerTo({ friction: 'held', loads: [] });
    expect(answer).toMatchObject({
      ok: true,
      message: expect.any(String),
      maxStress: expect.any(Number),
      safety: expect.any(Number),
      maxDisplacement: expect.any(Number),
      weight: expect.any(Number),
      tilt: expect.any(Number),
    });
    const { parts, samples, pins, reactions } = answer as Extract<StressAnswer, { ok: true }>;
    expect(parts.length).toBe(samples.length);
    expect(parts[0]).toEqual({
      stress: expect.any(Number),
      safety: expect.any(Number),
      utilisation: expect.any(Number),
    });
    expect(samples[0]?.[0]).toHaveLength(7);
    expect(pins[0]).toMatchObject({ part: expect.any(Number), shear: expect.any(Number) });
    expect(reactions[0]).toMatchObject({ at: expect.any(Array), force: expect.any(Array) });
  });

  test('names the parts that move where nothing holds them', () => {
    const answer = answerTo({ friction: 'free' });
    expect(answer).toMatchObject({ ok: false, message: expect.stringContaining('move') });
    expect((answer as Extract<StressAnswer, { ok: false }>).moving.length).toBeGreaterThan(0);
  });

  test('refuses options that it does not know', () => {
    expect(module.analyseStressJson(modelJson, '{"friction":"glue"}').status).toBe('invalidInput');
  });
});
