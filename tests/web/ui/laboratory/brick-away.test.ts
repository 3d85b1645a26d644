import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../../../../web/src/geometry/vec.ts';
import type { Model } from '../../../../web/src/model/model.ts';
import type { SolveResult } from '../../../../web/src/solver/worker-client.ts';
import {
  type AwayAsked,
  type AwayStep,
  beamUses,
  makeRow,
} from '../../../../web/src/ui/laboratory/brick-away.ts';
import { gridSketch, labSketches } from '../../../../web/src/ui/laboratory/lab-sketches.ts';
import { silentClient } from '../../helpers/silent-client.ts';
import { catalogue } from '../../view/helpers/catalogue.ts';

/** Numbers of beams of 5 and of 9 holes. */
const FIVE = '32316';
const NINE = '40490';

function modelOf(parts: readonly string[]): Model {
  const placed = parts.map((part) => ({
    part,
    color: 0,
    position: [0, 0, 0] as const,
    rotation: IDENTITY,
    component: 0,
    layer: 0,
    piece: 0,
  }));
  return { name: '', parts: placed };
}

const solved = (parts: readonly string[]): SolveResult => ({
  outcome: 'solved',
  modelJson: JSON.stringify(modelOf(parts)),
  reportJson: '{}',
  layoutJson: '{}',
  seconds: { total: 1, byPhase: {} },
});

function asked(changes: Partial<AwayAsked>): AwayAsked {
  const [sketch] = labSketches(gridSketch(1), []);
  if (sketch === undefined) {
    throw new Error('there are sketches');
  }
  return { sketch, catalogue, without: [], part: null, all: false, ...changes };
}

/** Answers every search with the next of `results`; @returns what came of it. */
async function rowOf(changes: Partial<AwayAsked>, results: readonly SolveResult[]) {
  const client = silentClient();
  const steps: AwayStep[] = [];
  const waiting = [...results];
  const ended = await makeRow(client, asked(changes), {
    onBegin: () =>
      queueMicrotask(() => {
        const result = waiting.shift();
        if (result) {
          client.solves.at(-1)?.settle(result);
        }
      }),
    onStep: (step) => steps.push(step),
    signal: new AbortController().signal,
  });
  return { ended, steps, settings: client.solves.map(({ settings }) => settings.set) };
}

it('beams are counted, the most used first; pins are none', () => {
  expect(beamUses(modelOf([NINE, FIVE, FIVE, '2780']), catalogue)).toEqual([
    { part: FIVE, count: 2 },
    { part: NINE, count: 1 },
  ]);
});

describe('a row of models', () => {
  it('goes on without the most used beam until there is no model', async () => {
    const { ended, steps, settings } = await rowOf({ all: true }, [
      solved([FIVE, FIVE, NINE]),
      solved([NINE]),
      { outcome: 'refused', message: 'no beams are left' },
    ]);
    expect(ended).toBe(true);
    expect(steps.map(({ without }) => without)).toEqual([[], [FIVE], [FIVE, NINE]]);
    expect(steps.at(-1)?.message).toBe('no beams are left');
    expect(settings.at(-1)).toEqual({ [`owned.${FIVE}`]: 0, [`owned.${NINE}`]: 0 });
  });

  it('is one model where one kind is taken', async () => {
    const { steps } = await rowOf({ without: [NINE], part: FIVE }, [solved([])]);
    expect(steps.map(({ without }) => without)).toEqual([[NINE, FIVE]]);
  });

  it('ends where it is stopped, and says so', async () => {
    const { ended, steps } = await rowOf({}, [{ outcome: 'cancelled', modelJson: null }]);
    expect(ended).toBe(false);
    expect(steps).toEqual([]);
  });
});
