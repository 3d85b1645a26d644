import { describe, expect, it } from 'vitest';
import type { StressOptions } from '../../../web/src/model/stress.ts';
import type { Question } from '../../../web/src/solver/protocol.ts';
import type { TextResult } from '../../../web/src/solver/worker-client.ts';
import { statusOf } from '../../../web/src/ui/checks/stress.tsx';
import { StressStudy, studyOf } from '../../../web/src/ui/checks/stress-study.ts';
import { stressResult } from '../helpers/stress-result.ts';

/** A solver that waits until the test answers. */
function waitingSolver() {
  const asked: { question: Question; answer: (reply: TextResult) => void }[] = [];
  const ask = (question: Question) =>
    new Promise<TextResult>((answer) => asked.push({ question, answer }));
  return { asked, solver: () => ({ ask }) };
}

const GOOD: TextResult = { outcome: 'ok', text: JSON.stringify(stressResult()) };
const settle = () => new Promise((done) => setTimeout(done));

function optionsOf(question: Question | undefined): StressOptions {
  return JSON.parse(question?.about === 'stress' ? question.optionsJson : 'null');
}

describe('StressStudy', () => {
  it('asks once, with what friction holds and no loads', () => {
    const { asked, solver } = waitingSolver();
    const study = new StressStudy('{}', solver);
    study.start();
    study.start();
    expect(asked).toHaveLength(1);
    expect(optionsOf(asked[0]?.question)).toEqual({ friction: 'held', loads: [] });
  });

  it('asks again with each load', async () => {
    const { asked, solver } = waitingSolver();
    const study = new StressStudy('{}', solver);
    study.addLoad({ at: [1, 2, 3], force: [0, 0, -5] });
    expect(optionsOf(asked[0]?.question).loads).toHaveLength(1);
    study.removeLoad(0);
    expect(optionsOf(asked[1]?.question).loads).toHaveLength(0);
  });

  it('keeps the answer to what was asked last, in whatever order they come', async () => {
    const { asked, solver } = waitingSolver();
    const study = new StressStudy('{}', solver);
    study.start();
    study.setFriction('free');
    asked[1]?.answer({ outcome: 'ok', text: '{"ok":false,"message":"folds","moving":[0]}' });
    await settle();
    asked[0]?.answer(GOOD);
    await settle();
    expect(study.progress.value).toMatchObject({ state: 'done', answer: { ok: false } });
  });

  it('says why there is no answer', async () => {
    const { asked, solver } = waitingSolver();
    const study = new StressStudy('{}', solver);
    study.start();
    asked[0]?.answer({ outcome: 'refused', message: 'part 3: not in the catalogue' });
    await settle();
    expect(study.progress.value).toEqual({
      state: 'failed',
      message: 'part 3: not in the catalogue',
    });
  });

  it('is one for each model', () => {
    const shown = { json: '{}', model: {} };
    expect(studyOf(shown)).toBe(studyOf(shown));
    expect(studyOf({ json: '{}', model: {} })).not.toBe(studyOf(shown));
  });
});

describe('the line of the check', () => {
  const options: StressOptions = { friction: 'held', loads: [] };
  const done = (safety: number) =>
    statusOf({ state: 'done', answer: { ...stressResult(), safety }, options });

  it('ticks what is far from breaking and warns of what is not', () => {
    expect(done(20)).toEqual({ state: 'ok', number: '× 20.0' });
    expect(done(1.1).state).toBe('bad');
  });

  it('gives no number without an answer', () => {
    expect(statusOf({ state: 'waiting' }).state).toBe('busy');
    expect(statusOf({ state: 'failed', message: 'no' })).toEqual({ state: 'none', number: '' });
  });
});
