import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { SolveProgress, SolveSettings } from '../../../web/src/solver/protocol.ts';
import {
  createSolverPool,
  settingsOfTry,
  workersFor,
} from '../../../web/src/solver/solver-pool.ts';
import type {
  SolveResult,
  SolverClient,
  SolveWatch,
} from '../../../web/src/solver/worker-client.ts';
import { silentClient } from '../helpers/silent-client.ts';

interface Running {
  readonly worker: number;
  readonly seed: number;
  readonly watch: SolveWatch;
  readonly settle: (result: SolveResult) => void;
  readonly fail: (error: Error) => void;
}

const PATIENCE_MS = 100;

/** A pool whose searches end when the test says so. */
function setUp(workers: number, seeds = 4) {
  const running: Running[] = [];
  let started = 0;
  const createClient = (): SolverClient => {
    const worker = started;
    started += 1;
    return {
      ...silentClient(),
      solve: (_sketch: string, settings: SolveSettings, watch: SolveWatch = {}) =>
        new Promise<SolveResult>((settle, fail) => {
          watch.signal?.addEventListener('abort', () =>
            settle({ outcome: 'cancelled', modelJson: null }),
          );
          running.push({ worker, seed: settings.seed ?? -1, watch, settle, fail });
        }),
    };
  };
  const pool = createSolverPool({ workers, seeds, patienceMs: PATIENCE_MS, createClient });
  const of = (seed: number): Running => {
    const found = running.find((one) => one.seed === seed);
    if (found === undefined) {
      throw new Error(`seed ${seed} was not started`);
    }
    return found;
  };
  return { pool, running, of };
}

function solved(seed: number, buildable: boolean, beams = 10): SolveResult {
  const reportJson = JSON.stringify({ seed, buildable, beams });
  return {
    outcome: 'solved',
    modelJson: `model ${seed}`,
    reportJson,
    layoutJson: 'l',
    seconds: { total: 1, byPhase: {} },
  };
}

function progress(beams: number, gaps = 0): SolveProgress {
  return {
    done: false,
    phase: 'stageTwo',
    iterations: 10,
    fraction: 0.5,
    objective: 1,
    temperature: 1,
    beams,
    gaps,
    collisions: 0,
    failedConnections: 0,
    terms: {},
    improvements: 1,
  };
}

const settled = () => vi.advanceTimersByTimeAsync(0);

beforeEach(() => {
  vi.useFakeTimers();
});

afterEach(() => {
  vi.useRealTimers();
});

test('a sketch that the first seed builds soon needs no second worker', async () => {
  const { pool, running, of } = setUp(3);
  const result = pool.solve('{}', { seed: 7 });
  of(7).settle(solved(7, true));
  expect(await result).toMatchObject({ modelJson: 'model 7' });
  await vi.advanceTimersByTimeAsync(10 * PATIENCE_MS);
  expect(running).toHaveLength(1);
});

test('further seeds start in workers of their own when the first takes long', async () => {
  const { pool, running } = setUp(3);
  const result = pool.solve('{}', { seed: 1 });
  await vi.advanceTimersByTimeAsync(PATIENCE_MS);
  expect(running.map(({ worker, seed }) => [worker, seed])).toEqual([
    [0, 1],
    [1, 2],
    [2, 3],
  ]);
  running[0]?.settle(solved(1, true));
  expect(await result).toMatchObject({ modelJson: 'model 1' });
});

test.each([1, 2, 4])('with %i workers the lowest seed that is buildable wins', async (workers) => {
  const { pool, running } = setUp(workers);
  const result = pool.solve('{}', { seed: 1 });
  await vi.advanceTimersByTimeAsync(PATIENCE_MS);
  // Seeds 3 and 4 are buildable; whoever is under way ends, the highest seed first.
  const ended = new Set<number>();
  for (let turn = 0; turn < 4; turn += 1) {
    const open = running.filter(({ seed }) => !ended.has(seed));
    const last = open.at(-1);
    if (last !== undefined) {
      ended.add(last.seed);
      last.settle(solved(last.seed, last.seed >= 3, last.seed === 4 ? 5 : 10));
      await settled();
    }
  }
  expect(await result).toMatchObject({ modelJson: 'model 3' });
});

test('without a buildable model the best of all seeds is kept', async () => {
  const { pool, of } = setUp(1, 3);
  const result = pool.solve('{}', { seed: 1 });
  for (const [seed, beams] of [
    [1, 12],
    [2, 9],
    [3, 11],
  ] as const) {
    of(seed).settle(solved(seed, false, beams));
    await settled();
  }
  expect(await result).toMatchObject({ modelJson: 'model 2' });
});

test('a refusal of one seed ends them all', async () => {
  const { pool, of } = setUp(2);
  const result = pool.solve('{', {});
  await vi.advanceTimersByTimeAsync(PATIENCE_MS);
  of(1).settle({ outcome: 'refused', message: 'not JSON' });
  expect(await result).toEqual({ outcome: 'refused', message: 'not JSON' });
  expect(of(2).watch.signal?.aborted).toBe(true);
});

test('a crash of one worker rejects the solve and stops the others', async () => {
  const { pool, of } = setUp(2);
  const result = pool.solve('{}', {});
  await vi.advanceTimersByTimeAsync(PATIENCE_MS);
  of(2).fail(new Error('out of memory'));
  await expect(result).rejects.toThrow('out of memory');
  expect(of(1).watch.signal?.aborted).toBe(true);
});

test('a cancel settles at once with the model that was shown', async () => {
  const { pool, of } = setUp(2);
  const abort = new AbortController();
  const result = pool.solve('{}', {}, { signal: abort.signal });
  of(1).watch.onProgress?.(progress(9), 'early');
  abort.abort();
  expect(await result).toEqual({ outcome: 'cancelled', modelJson: 'early' });
  expect(of(1).watch.signal?.aborted).toBe(true);
});

test('the model of the leading seed is shown, once', async () => {
  const { pool, of } = setUp(2);
  const shown: (string | null)[] = [];
  const result = pool.solve('{}', {}, { onProgress: (_, model) => shown.push(model) });
  await vi.advanceTimersByTimeAsync(PATIENCE_MS);
  of(1).watch.onProgress?.(progress(9, 1), 'a gap');
  of(2).watch.onProgress?.(progress(12, 0), 'no gap');
  of(1).watch.onProgress?.(progress(8, 1), 'a gap still');
  of(1).watch.onProgress?.(progress(8, 0), 'fewer beams');
  expect(shown).toEqual(['a gap', 'no gap', null, 'fewer beams']);
  of(1).settle(solved(1, true));
  expect(await result).toMatchObject({ modelJson: 'model 1' });
});

test('a search does not wait for the check of an earlier model', async () => {
  const asked: string[] = [];
  let started = 0;
  const createClient = (): SolverClient => {
    const worker = started;
    started += 1;
    const never = (what: string) => {
      asked.push(`${what} ${worker}`);
      return new Promise<never>(() => undefined);
    };
    return { ...silentClient(), check: () => never('check'), solve: () => never('solve') };
  };
  const pool = createSolverPool({ workers: 1, createClient });
  void pool.check('{}');
  void pool.solve('{}', {});
  expect(asked).toEqual(['check 0', 'solve 1']);
  // There is room for no third one.
  void pool.check('{}');
  expect(asked).toEqual(['check 0', 'solve 1', 'check 0']);
});

test('an earlier layout has one try, and then the seeds are those of a search without it', () => {
  const tries = (settings: SolveSettings) => [0, 1, 2].map((i) => settingsOfTry(settings, i));
  expect(tries({ seed: 5 })).toEqual([{ seed: 5 }, { seed: 6 }, { seed: 7 }]);
  expect(tries({ seed: 5, earlier: 'x' })).toEqual([
    { seed: 5, earlier: 'x' },
    { seed: 5 },
    { seed: 6 },
  ]);
});

test('one core is left to the page, and four workers are enough', () => {
  expect([1, 2, 4, 16].map(workersFor)).toEqual([1, 1, 3, 4]);
});
