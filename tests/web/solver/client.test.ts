import { expect, test, vi } from 'vitest';
import { createSolverClient } from '../../../web/src/solver/client.ts';
import type { FromWorker, SolveProgress, ToWorker } from '../../../web/src/solver/protocol.ts';
import {
  type SolverClient,
  SolverError,
  type WorkerPort,
} from '../../../web/src/solver/worker-client.ts';

/** A worker that answers only when the test says so. */
class ScriptedWorker implements WorkerPort {
  onmessage: WorkerPort['onmessage'] = null;
  onerror: WorkerPort['onerror'] = null;
  onmessageerror: WorkerPort['onmessageerror'] = null;
  readonly received: ToWorker[] = [];
  terminated = false;

  postMessage(message: ToWorker): void {
    this.received.push(message);
  }

  terminate(): void {
    this.terminated = true;
  }

  reply(data: FromWorker): void {
    this.onmessage?.({ data });
  }
}

const PROGRESS: SolveProgress = {
  done: false,
  phase: 'stageTwo',
  iterations: 10,
  fraction: 0.5,
  objective: 1,
  temperature: 1,
  beams: 3,
  gaps: 0,
  collisions: 0,
  failedConnections: 0,
  terms: {},
  improvements: 1,
};

function setUp() {
  const workers: ScriptedWorker[] = [];
  const client = createSolverClient({
    cancelPatienceMs: 50,
    startWorker: () => {
      const worker = new ScriptedWorker();
      workers.push(worker);
      return worker;
    },
  });
  const worker = (i: number): ScriptedWorker => {
    const found = workers[i];
    if (found === undefined) {
      throw new Error(`no worker ${i} was started`);
    }
    return found;
  };
  return { client, workers, worker };
}

test('a solve gives progress and settles with the model', async () => {
  const { client, worker } = setUp();
  const seen: (string | null)[] = [];
  const result = client.solve('{}', { seed: 7 }, { onProgress: (_, model) => seen.push(model) });
  expect(worker(0).received).toEqual([
    { kind: 'start', jobId: 1, sketchJson: '{}', settings: { seed: 7 } },
  ]);
  worker(0).reply({ kind: 'progress', jobId: 1, progress: PROGRESS, modelJson: 'm1' });
  worker(0).reply({ kind: 'progress', jobId: 1, progress: PROGRESS, modelJson: null });
  const seconds = { total: 1, byPhase: {} };
  worker(0).reply({
    kind: 'solved',
    jobId: 1,
    modelJson: 'm2',
    reportJson: 'r',
    layoutJson: 'l',
    seconds,
  });
  expect(await result).toEqual({
    outcome: 'solved',
    modelJson: 'm2',
    reportJson: 'r',
    layoutJson: 'l',
    seconds,
  });
  expect(seen).toEqual(['m1', null]);
});

test('a cancel settles at once with the last model, before the worker answers', async () => {
  const { client, worker } = setUp();
  const abort = new AbortController();
  const result = client.solve('{}', {}, { signal: abort.signal });
  worker(0).reply({ kind: 'progress', jobId: 1, progress: PROGRESS, modelJson: 'm1' });
  abort.abort();
  expect(await result).toEqual({ outcome: 'cancelled', modelJson: 'm1' });
  expect(worker(0).received.at(-1)).toEqual({ kind: 'cancel', jobId: 1 });
});

test('a worker that confirms the cancel is kept', async () => {
  vi.useFakeTimers();
  const { client, workers, worker } = setUp();
  const abort = new AbortController();
  const result = client.solve('{}', {}, { signal: abort.signal });
  abort.abort();
  worker(0).reply({ kind: 'cancelled', jobId: 1 });
  await vi.advanceTimersByTimeAsync(1000);
  expect((await result).outcome).toBe('cancelled');
  expect(worker(0).terminated).toBe(false);
  expect(workers).toHaveLength(1);
  vi.useRealTimers();
});

test('a worker that is stuck after a cancel is replaced, and what else was asked is asked again', async () => {
  vi.useFakeTimers();
  const { client, worker } = setUp();
  const abort = new AbortController();
  const solve = client.solve('{}', {}, { signal: abort.signal });
  const check = client.check('model');
  abort.abort();
  await vi.advanceTimersByTimeAsync(60);
  expect(worker(0).terminated).toBe(true);
  expect(worker(1).received).toEqual([{ kind: 'check', jobId: 2, modelJson: 'model' }]);
  worker(1).reply({ kind: 'checked', jobId: 2, checkJson: '{}' });
  expect((await solve).outcome).toBe('cancelled');
  expect(await check).toEqual({ outcome: 'ok', text: '{}' });
  vi.useRealTimers();
});

const JOBS = {
  check: (client: SolverClient, signal: AbortSignal) => client.check('m', signal),
  export: (client: SolverClient, signal: AbortSignal) => client.exportModel('m', 'mpd', signal),
  question: (client: SolverClient, signal: AbortSignal) =>
    client.ask({ about: 'motion', modelJson: 'm' }, signal),
};

test.each(Object.entries(JOBS))(
  'a cancelled %s settles at once, and its worker is gone within 100 ms',
  async (_, begin) => {
    vi.useFakeTimers();
    const { workers, worker } = setUp();
    const client = createSolverClient({
      startWorker: () => {
        const started = new ScriptedWorker();
        workers.push(started);
        return started;
      },
    });
    const abort = new AbortController();
    const job = begin(client, abort.signal);
    abort.abort();
    await expect(job).rejects.toBe(abort.signal.reason);
    await vi.advanceTimersByTimeAsync(100);
    expect(worker(0).terminated).toBe(true);
    // The next one is asked of another.
    const next = begin(client, new AbortController().signal);
    worker(1).reply({ kind: 'refused', jobId: 2, message: 'no' });
    expect(await next).toEqual({ outcome: 'refused', message: 'no' });
    vi.useRealTimers();
  },
);

test('a cancelled check whose worker answers in time keeps it', async () => {
  vi.useFakeTimers();
  const { client, worker } = setUp();
  const abort = new AbortController();
  const job = client.check('m', abort.signal);
  abort.abort();
  worker(0).reply({ kind: 'checked', jobId: 1, checkJson: '{}' });
  await expect(job).rejects.toBe(abort.signal.reason);
  await vi.advanceTimersByTimeAsync(1000);
  expect(worker(0).terminated).toBe(false);
  vi.useRealTimers();
});

test('a signal that is aborted already starts nothing', async () => {
  const { client, workers } = setUp();
  const result = await client.solve('{}', {}, { signal: AbortSignal.abort() });
  expect(result).toEqual({ outcome: 'cancelled', modelJson: null });
  expect(workers).toHaveLength(0);
});

test('a refusal is a result with its message', async () => {
  const { client, worker } = setUp();
  const result = client.solve('{', {});
  worker(0).reply({ kind: 'refused', jobId: 1, message: 'not JSON' });
  expect(await result).toEqual({ outcome: 'refused', message: 'not JSON' });
});

test('what a dead worker had not answered is asked of a new one', async () => {
  const { client, worker } = setUp();
  const solve = client.solve('{}', {});
  const check = client.check('model');
  worker(0).onerror?.({ message: 'out of memory' });
  expect(worker(0).terminated).toBe(true);
  expect(worker(1).received).toEqual(worker(0).received);
  worker(1).reply({ kind: 'refused', jobId: 1, message: 'not JSON' });
  worker(1).reply({ kind: 'checked', jobId: 2, checkJson: '{}' });
  expect(await solve).toEqual({ outcome: 'refused', message: 'not JSON' });
  expect(await check).toEqual({ outcome: 'ok', text: '{}' });
});

test('a job over which two workers die is given up, and the next one gets a new worker', async () => {
  const { client, worker } = setUp();
  const solve = client.solve('{}', {});
  worker(0).onerror?.({ message: 'out of memory' });
  const check = client.check('model');
  worker(1).onerror?.({ message: 'out of memory' });
  await expect(solve).rejects.toThrow(SolverError);
  expect(worker(2).received).toEqual([{ kind: 'check', jobId: 2, modelJson: 'model' }]);
  worker(2).reply({ kind: 'checked', jobId: 2, checkJson: '{}' });
  expect(await check).toEqual({ outcome: 'ok', text: '{}' });
});

test('a failed reply ends its job alone, and its worker', async () => {
  const { client, worker } = setUp();
  const solve = client.solve('{}', {});
  const check = client.check('model');
  worker(0).reply({ kind: 'failed', jobId: 1, message: 'check failed' });
  await expect(solve).rejects.toThrow('check failed');
  expect(worker(0).terminated).toBe(true);
  worker(1).reply({ kind: 'checked', jobId: 2, checkJson: '{}' });
  expect(await check).toEqual({ outcome: 'ok', text: '{}' });
});

test('a cancelled job is not asked again when its worker dies', async () => {
  const { client, workers, worker } = setUp();
  const abort = new AbortController();
  const solve = client.solve('{}', {}, { signal: abort.signal });
  abort.abort();
  worker(0).onerror?.({ message: 'out of memory' });
  expect((await solve).outcome).toBe('cancelled');
  expect(workers).toHaveLength(1);
});

test('dispose settles what is open', async () => {
  const { client, worker } = setUp();
  const solve = client.solve('{}', {});
  const check = client.check('model');
  client.dispose();
  expect((await solve).outcome).toBe('cancelled');
  await expect(check).rejects.toThrow('closed');
  expect(worker(0).terminated).toBe(true);
});
