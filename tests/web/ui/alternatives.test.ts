import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../../web/src/geometry/vec.ts';
import type { SolveResult } from '../../../web/src/solver/worker-client.ts';
import {
  bestIn,
  candidates,
  type Figures,
  modelText,
} from '../../../web/src/ui/alternatives/alternatives.ts';
import {
  type Alternative,
  findAlternatives,
} from '../../../web/src/ui/alternatives/find-alternatives.ts';
import { silentClient, type TestClient } from '../helpers/silent-client.ts';

const part = (id: string, x: number) => ({
  part: id,
  color: 0,
  position: [x, 0, 0] as const,
  rotation: IDENTITY,
  component: 0,
  layer: 0,
  piece: 0,
});

const figures = (changes: Partial<Figures> = {}): Figures => ({
  bricks: 10,
  kinds: 3,
  deviation: 0.5,
  freedoms: 0,
  mass: 20,
  buildable: true,
  wellBuilt: [5, 6],
  ...changes,
});

describe('what is searched for', () => {
  it('is every preset once, and the one in force with another seed', () => {
    const all = candidates({ preset: 'simple', seed: 3 });
    expect(all.map(({ preset, seed }) => `${preset} ${seed}`)).toEqual([
      'simple 3',
      'balanced 3',
      'faithful 3',
      'simple-rigid 3',
      'faithful-rigid 3',
      'simple 1003',
    ]);
  });
});

describe('equal models', () => {
  it('have the same parts in the same places, in any order', () => {
    const [a, b] = [part('32316', 0), part('2780', 4)];
    const text = (parts: (typeof a)[]) => modelText({ name: '', parts });
    expect(text([a, b])).toBe(text([b, { ...a, color: 4 }]));
    expect(text([a, b])).not.toBe(text([a, part('2780', 5)]));
  });
});

describe('the best', () => {
  it('has the least of a figure, and shares it with its equals', () => {
    const best = bestIn([figures({ bricks: 8 }), figures(), figures({ bricks: 8, mass: 18 })]);
    expect(best.map((each) => [...each])).toEqual([['bricks'], [], ['bricks', 'mass']]);
  });

  it('is nobody where all are alike', () => {
    expect(bestIn([figures(), figures()]).map((each) => each.size)).toEqual([0, 0]);
  });

  it('can be built', () => {
    const best = bestIn([
      figures({ bricks: 1, buildable: false }),
      figures({ bricks: 9 }),
      figures(),
    ]);
    expect(best.map((each) => [...each])).toEqual([[], ['bricks'], []]);
  });
});

describe('the search', () => {
  const sketch = { format: 'technic-sketch', version: 1, lines: [] } as const;
  const model = (x: number) => JSON.stringify({ name: '', parts: [part('32316', x)] });

  /** Answers the search that waits. */
  async function answer(client: TestClient, result: Partial<SolveResult>): Promise<void> {
    await expect.poll(() => client.solves.length).toBeGreaterThan(0);
    const rest = { reportJson: '{}', layoutJson: '{}', seconds: { total: 0, byPhase: {} } };
    client.solves.shift()?.settle({ ...rest, ...result } as SolveResult);
  }

  function begin(client: TestClient, signal: AbortSignal) {
    const found: Alternative[] = [];
    let tried = 0;
    const asked = {
      sketch,
      candidates: candidates({ preset: 'balanced', seed: 1 }).slice(0, 3),
      settingsOf: ({ preset, seed }: { preset: string; seed: number }) => ({ preset, seed }),
    };
    const watch = {
      known: modelText({ name: '', parts: [part('32316', 0)] }),
      onFound: (one: Alternative) => found.push(one),
      onTried: () => {
        tried += 1;
      },
      signal,
    };
    return { found, tried: () => tried, end: findAlternatives(client, asked, watch) };
  }

  it('leaves out what is on the page, what was found before, and what is refused', async () => {
    const client = silentClient();
    const run = begin(client, new AbortController().signal);
    await answer(client, { outcome: 'solved', modelJson: model(0) });
    await answer(client, { outcome: 'solved', modelJson: model(1) });
    await answer(client, { outcome: 'refused', message: 'no' });
    await run.end;
    expect(run.found.map(({ candidate }) => candidate.id)).toEqual(['simple']);
    expect(run.tried()).toBe(3);
  });

  it('ends when it is stopped', async () => {
    const client = silentClient();
    const stop = new AbortController();
    const run = begin(client, stop.signal);
    await expect.poll(() => client.solves.length).toBe(1);
    stop.abort();
    await run.end;
    expect(run.found).toEqual([]);
    expect(client.solves).toHaveLength(1);
  });
});
