import { expect, test, vi } from 'vitest';
import type { FromProver, ToProver } from '../../../web/src/solver/proof/messages.ts';
import { type ProverPort, proveInWorker } from '../../../web/src/solver/proof-client.ts';
import { statusOf } from '../../../web/src/ui/checks/proof.tsx';
import { ProofStudy } from '../../../web/src/ui/checks/proof-study.ts';

/** A worker that answers when the test says so. */
class FakeProver implements ProverPort {
  onmessage: ProverPort['onmessage'] = null;
  onerror: ProverPort['onerror'] = null;
  readonly asked: ToProver[] = [];
  readonly terminate = vi.fn();

  postMessage(message: ToProver): void {
    this.asked.push(message);
  }

  say(data: FromProver): void {
    this.onmessage?.({ data });
  }
}

const CERTIFICATE = {
  format: 'liftarm-certificate',
  version: 1,
  name: '',
  bound: 7,
  unit: 1,
  pieces: [],
} as const;

test('a prover is ended when it has answered', async () => {
  const prover = new FakeProver();
  const proof = proveInWorker('{}', {}, () => prover);
  prover.say({ kind: 'proved', certificate: CERTIFICATE });
  expect((await proof)?.bound).toBe(7);
  expect(prover.terminate).toHaveBeenCalledOnce();
});

test('a proof that is cancelled ends its prover at once', async () => {
  const prover = new FakeProver();
  const abort = new AbortController();
  const proof = proveInWorker('{}', { signal: abort.signal }, () => prover);
  abort.abort();
  expect(await proof).toBeNull();
  expect(prover.terminate).toHaveBeenCalledOnce();
});

test('a prover that breaks rejects', async () => {
  const prover = new FakeProver();
  const proof = proveInWorker('{}', {}, () => prover);
  prover.onerror?.({ message: 'no memory' });
  await expect(proof).rejects.toThrow('no memory');
});

function studyWith(prover: FakeProver): ProofStudy {
  return new ProofStudy({
    solver: () => ({ ask: () => Promise.resolve({ outcome: 'ok', text: 'listed' }) }),
    prove: (text, watch) => proveInWorker(text, watch, () => prover),
  });
}

test('a study hands on what the core lists and keeps what is proved', async () => {
  const prover = new FakeProver();
  const study = studyWith(prover);
  const ended = study.start('{}', {});
  await vi.waitFor(() => expect(prover.asked).toEqual([{ placementsJson: 'listed' }]));
  prover.say({ kind: 'progress', progress: { done: 1, pieces: 2, leaves: 3 } });
  expect(study.now.value).toMatchObject({ state: 'working', progress: { leaves: 3 } });
  prover.say({ kind: 'proved', certificate: CERTIFICATE });
  await ended;
  expect(study.now.value).toEqual({ state: 'proved', bound: 7 });
});

test('a study that is stopped is open again', async () => {
  const prover = new FakeProver();
  const study = studyWith(prover);
  const ended = study.start('{}', {});
  await vi.waitFor(() => expect(prover.asked).toHaveLength(1));
  study.stop();
  await ended;
  expect(study.now.value).toEqual({ state: 'open' });
  expect(prover.terminate).toHaveBeenCalledOnce();
});

test('a study that is stopped while the core lists places ends that question', async () => {
  let signal: AbortSignal | undefined;
  const prove = vi.fn();
  const study = new ProofStudy({
    solver: () => ({
      ask: (_, stopped) => {
        signal = stopped;
        return new Promise((_resolve, reject) => {
          stopped?.addEventListener('abort', () => reject(stopped.reason));
        });
      },
    }),
    prove,
  });
  const ended = study.start('{}', {});
  study.stop();
  await ended;
  expect(signal?.aborted).toBe(true);
  expect(study.now.value).toEqual({ state: 'open' });
  expect(prove).not.toHaveBeenCalled();
});

test('a bound that the model meets is a proof already', () => {
  const shown = (beams: number) => ({ report: { beams, beamsLowerBound: 6, axles: 1 } });
  expect(statusOf(shown(6), { state: 'open' }).state).toBe('ok');
  expect(statusOf(shown(7), { state: 'open' })).toMatchObject({ state: 'none' });
  // Seven beams and axles at least, of which one is an axle.
  expect(statusOf(shown(6), { state: 'proved', bound: 7 }).state).toBe('ok');
  expect(statusOf(shown(7), { state: 'proved', bound: 8 }).state).toBe('ok');
  expect(statusOf({ report: null }, { state: 'open' }).state).toBe('none');
});
