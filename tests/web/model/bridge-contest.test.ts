import { describe, expect, test } from 'vitest';
import {
  BRIDGE_DEFAULTS,
  type BridgeContest,
  faultOfContest,
  type LoadedState,
  placesOf,
  priceOf,
  scoreBridge,
  truckLoads,
} from '../../../web/src/model/contest/bridge.ts';
import type { PointLoad } from '../../../web/src/model/stress.ts';

const CONTEST: BridgeContest = {
  ...BRIDGE_DEFAULTS,
  deck: { from: [0, 3, 6], to: [20, 3, 6] },
  truck: { axles: [0, 6], forces: [4, 10], track: 2 },
};

const weightOf = (loads: readonly PointLoad[]) =>
  loads.reduce((sum, { force }) => sum - force[2], 0);

describe('the truck', () => {
  test('weighs all it weighs where both axles are on the deck', () => {
    expect(weightOf(truckLoads(CONTEST, 10))).toBeCloseTo(14);
  });

  test('brings one axle after the other onto the deck and off it', () => {
    expect(weightOf(truckLoads(CONTEST, 2))).toBeCloseTo(4);
    expect(weightOf(truckLoads(CONTEST, 25))).toBeCloseTo(10);
    expect(truckLoads(CONTEST, 27)).toEqual([]);
  });

  test('has its wheels on both sides of the middle of the lane', () => {
    const sides = truckLoads(CONTEST, 10).map(({ at }) => at[1]);
    expect([...new Set(sides)].sort()).toEqual([2, 4]);
    for (const { at } of truckLoads(CONTEST, 10)) {
      expect(at[2]).toBe(6);
    }
  });

  test('is looked at until its last axle has left', () => {
    const places = placesOf({ ...CONTEST, step: 0.5 });
    expect(places[0]).toBe(0);
    expect(places.at(-1)).toBe(26);
    expect(places).toHaveLength(53);
  });
});

describe('the price', () => {
  test('is that of the list, and of the mass where a part is not on it', () => {
    const contest = { ...CONTEST, prices: { a: 3 }, pricePerGram: 2 };
    expect(priceOf(contest, ['a', 'a', 'b'], () => 1.5)).toBe(9);
  });
});

describe('the score', () => {
  const score = (stressOf: (loads: readonly PointLoad[]) => LoadedState) =>
    scoreBridge(CONTEST, ['x'], { massOf: () => 1, stressOf });

  test('is the price of a bridge that holds all along', () => {
    const found = score(() => ({ stands: true, safety: 1.2, displacement: 0 }));
    expect(found).toMatchObject({ holds: true, score: 10, price: 10 });
  });

  test('is none where one place of the truck is too much, and names that place', () => {
    const found = score((loads) => ({
      stands: true,
      safety: weightOf(loads) > 13 ? 0.9 : 3,
      displacement: 1,
    }));
    expect(found).toMatchObject({ holds: false, score: null });
    expect(found.worst.front).toBeGreaterThanOrEqual(6);
    expect(found.worst.front).toBeLessThanOrEqual(20);
  });

  test('is none for a bridge that folds somewhere, however strong it is elsewhere', () => {
    const found = score((loads) => ({
      stands: weightOf(loads) < 10,
      safety: 9,
      displacement: 0,
    }));
    expect(found).toMatchObject({ holds: false, score: null });
    expect(found.worst.stands).toBe(false);
  });
});

test('a contest that cannot be held says why', () => {
  expect(faultOfContest(CONTEST)).toBeNull();
  expect(faultOfContest({ ...CONTEST, deck: { from: [0, 0, 0], to: [0, 0, 9] } })).toContain(
    'deck',
  );
  const truck = { axles: [0, 5], forces: [1], track: 0 };
  expect(faultOfContest({ ...CONTEST, truck })).toContain('forces');
  expect(faultOfContest({ ...CONTEST, step: 0 })).toContain('step');
});
