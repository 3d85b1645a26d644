import { describe, expect, it } from 'vitest';
import type { SolveProgress } from '../../../../web/src/solver/protocol.ts';
import type { SolveResult } from '../../../../web/src/solver/worker-client.ts';
import { gridSketch, labSketches } from '../../../../web/src/ui/laboratory/lab-sketches.ts';
import { newRun, type Run, race, thinned } from '../../../../web/src/ui/laboratory/race.ts';
import { FIRST_PLAN, settingsOfRun } from '../../../../web/src/ui/laboratory/race-plan.ts';
import { csvOf, exponentOf, resultsOf } from '../../../../web/src/ui/laboratory/race-results.ts';
import { silentClient, type TestClient } from '../../helpers/silent-client.ts';

const NOTHING = gridSketch(1);

function runsOf(ids: readonly string[]): Run[] {
  const sketches = labSketches(NOTHING, []).filter(({ id }) => ids.includes(id));
  return sketches.map((sketch) => newRun(sketch, 'default', settingsOfRun(FIRST_PLAN, 'default')));
}

const solved = (report: object): SolveResult => ({
  outcome: 'solved',
  modelJson: '{"name":"","parts":[]}',
  reportJson: JSON.stringify(report),
  layoutJson: '{}',
  seconds: { total: 2, byPhase: {} },
});

const PROGRESS: SolveProgress = {
  done: false,
  phase: 'rounds',
  iterations: 1,
  fraction: 0.5,
  objective: 3,
  temperature: 1,
  beams: 4,
  gaps: 1,
  collisions: 2,
  failedConnections: 0,
  improvements: 1,
  terms: {},
};

function track(lanes: number) {
  const clients: TestClient[] = [];
  let disposed = 0;
  let time = 0;
  const options = {
    lanes,
    createClient: () => {
      const client = { ...silentClient(), dispose: () => (disposed += 1) };
      clients.push(client);
      return client;
    },
    now: () => time,
  };
  const settled = () => new Promise((resolve) => setTimeout(resolve));
  const pass = (ms: number) => {
    time += ms;
  };
  return { clients, options, settled, pass, disposed: () => disposed };
}

const phases = (runs: readonly Run[]) => runs.map(({ state }) => state.value.phase);

describe('a race', () => {
  it('has as many searches at a time as there are lanes, and the next when one ends', async () => {
    const { clients, options, settled, disposed } = track(2);
    const runs = runsOf(['grid-1', 'grid-2', 'grid-3']);
    const over = race(runs, options, new AbortController().signal);
    await settled();
    expect(phases(runs)).toEqual(['running', 'running', 'waiting']);
    clients[1]?.solves[0]?.settle(solved({ beams: 6 }));
    await settled();
    expect(phases(runs)).toEqual(['running', 'done', 'running']);
    clients[0]?.solves[0]?.settle(solved({ beams: 4 }));
    clients[1]?.solves[1]?.settle(solved({ beams: 8 }));
    await over;
    expect(phases(runs)).toEqual(['done', 'done', 'done']);
    expect(disposed()).toBe(2);
  });

  it('stops all that run and begins no other', async () => {
    const { options } = track(1);
    const stop = new AbortController();
    const runs = runsOf(['grid-1', 'grid-2']);
    const over = race(runs, options, stop.signal);
    stop.abort();
    await over;
    expect(phases(runs)).toEqual(['stopped', 'stopped']);
  });

  it('goes on where one is refused or fails, and says why', async () => {
    const { clients, options, settled } = track(1);
    const runs = runsOf(['grid-1', 'grid-2']);
    const over = race(runs, options, new AbortController().signal);
    await settled();
    clients[0]?.solves[0]?.settle({ outcome: 'refused', message: 'too long' });
    await settled();
    clients[0]?.solves[1]?.fail(new Error('no memory'));
    await over;
    expect(phases(runs)).toEqual(['refused', 'failed']);
    expect(runs.map(({ state }) => state.value.message)).toEqual(['too long', 'no memory']);
  });

  it('shows where a search stands, over its own seconds', async () => {
    const { clients, options, settled, pass } = track(1);
    const runs = runsOf(['grid-1']);
    const stop = new AbortController();
    const over = race(runs, options, stop.signal);
    await settled();
    pass(1500);
    clients[0]?.solves[0]?.watch.onProgress?.(PROGRESS, '{"name":"early","parts":[]}');
    const { fraction, points, model } = runs[0]?.state.value ?? {};
    expect(fraction).toBe(0.5);
    expect(points).toEqual([{ seconds: 1.5, objective: 3, beams: 4, gaps: 1, faults: 3 }]);
    expect(model?.name).toBe('early');
    stop.abort();
    await over;
  });
});

describe('results', () => {
  it('are those that have ended, with gaps as the paper counts them', async () => {
    const { clients, options, settled } = track(1);
    const runs = runsOf(['grid-1']);
    const over = race(runs, options, new AbortController().signal);
    await settled();
    expect(resultsOf(runs)).toEqual([]);
    const report = { beams: 4, axles: 1, gaps: 1, filledGaps: 2, length: 16, buildable: true };
    clients[0]?.solves[0]?.settle(solved(report));
    await over;
    expect(resultsOf(runs)).toMatchObject([
      { sketch: 'grid-1', method: 'default', beams: 5, gaps: 3, buildable: true, seconds: 2 },
    ]);
  });

  it('are a table with a head as CSV', () => {
    const csv = csvOf([
      {
        sketch: 'grid-1',
        method: 'greedy',
        length: 16,
        beams: 4,
        bricks: 8,
        gaps: 0,
        collisions: 0,
        failedConnections: 0,
        buildable: true,
        seconds: 0.12345,
      },
    ]);
    expect(csv.split('\n')).toEqual([
      'sketch,method,length,beams,bricks,gaps,collisions,failedConnections,buildable,seconds',
      'grid-1,greedy,16,4,8,0,0,0,yes,0.123',
      '',
    ]);
  });

  it('grow with an exponent that is found again', () => {
    const points = [1, 2, 4, 8].map((x) => ({ x, y: 3 * x ** 1.5 }));
    expect(exponentOf(points)).toBeCloseTo(1.5, 9);
    expect(exponentOf(points.slice(0, 2))).toBeNull();
  });
});

it('a long curve keeps its ends', () => {
  const points = thinned(Array.from({ length: 601 }, (_, i) => i));
  expect(points.length).toBeLessThan(400);
  expect([points[0], points.at(-1)]).toEqual([0, 600]);
});
