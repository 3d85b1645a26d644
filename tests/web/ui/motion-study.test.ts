import { describe, expect, it } from 'vitest';
import type { Question } from '../../../web/src/solver/protocol.ts';
import type { TextResult } from '../../../web/src/solver/worker-client.ts';
import { MotionStudy, motionStudyOf } from '../../../web/src/ui/checks/motion-study.ts';

function answering(reply: TextResult) {
  const asked: Question[] = [];
  return {
    asked,
    solver: () => ({
      ask: (question: Question) => {
        asked.push(question);
        return Promise.resolve(reply);
      },
    }),
  };
}

const settle = () => new Promise((done) => setTimeout(done));
const GOOD: TextResult = { outcome: 'ok', text: '{"turns":false,"parts":[]}' };

describe('MotionStudy', () => {
  it('asks about a model once', async () => {
    const { asked, solver } = answering(GOOD);
    const study = new MotionStudy('{}', solver);
    study.start();
    study.start();
    await settle();
    expect(asked).toEqual([{ about: 'motion', modelJson: '{}' }]);
    expect(study.progress.value.state).toBe('done');
  });

  it('asks about each motion once', async () => {
    const { asked, solver } = answering(GOOD);
    const study = new MotionStudy('{}', solver);
    await study.path({ of: 'joint', index: 2 });
    await study.path({ of: 'joint', index: 2 });
    await study.path({ of: 'motion', index: 2 });
    expect(asked).toHaveLength(2);
  });

  it('tells why there is no answer', async () => {
    const { solver } = answering({ outcome: 'refused', message: 'no such file' });
    const study = new MotionStudy('{}', solver);
    study.start();
    await settle();
    expect(study.progress.value).toEqual({ state: 'failed', message: 'no such file' });
    await expect(study.path({ of: 'joint', index: 0 })).rejects.toThrow('no such file');
  });

  it('is one for one model', () => {
    const shown = { json: '{}', model: {} };
    expect(motionStudyOf(shown)).toBe(motionStudyOf({ ...shown }));
    expect(motionStudyOf(shown)).not.toBe(motionStudyOf({ json: '{}', model: {} }));
  });
});
