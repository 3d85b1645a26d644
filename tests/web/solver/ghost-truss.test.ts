import loadHighs, { type Highs } from 'highs';
import { beforeAll, describe, expect, it } from 'vitest';
import { BRIDGE_DEFAULTS, type BridgeContest } from '../../../web/src/model/contest/bridge.ts';
import { lineLength } from '../../../web/src/model/sketch.ts';
import {
  faultOfGhost,
  ghostSketch,
  ghostTruss,
  joinedBars,
} from '../../../web/src/solver/truss/ghost-truss.ts';

/** One wheel of `force` that stands still in the middle of a deck on the table. */
function middleLoad(along: number, height: number, force: number): BridgeContest {
  return {
    ...BRIDGE_DEFAULTS,
    deck: { from: [0, 0, height], to: [along, 0, height] },
    truck: { axles: [0], forces: [force], track: 0 },
    step: along / 2,
  };
}

describe('the ghost truss', () => {
  let highs: Highs;
  beforeAll(async () => {
    highs = await loadHighs();
  });

  it('of a load on two posts over a span of two bars is the triangle that statics gives', () => {
    // Nodes 2 apart, so 6-8-10 is the only slope: from both feet up to a load 8 above the middle of 12.
    const { volume, members } = ghostTruss(middleLoad(12, 8, 10), highs);
    // Slopes: 10 / (2 * 0.8) = 6.25 N in 10 modules each; tie: 3.75 N in 12.
    // The truck's other places load the posts above the feet: 10 N in 8 modules each.
    expect(volume).toBeCloseTo(2 * 6.25 * 10 + 3.75 * 12 + 2 * 10 * 8, 4);
    const slopes = members.filter(({ from, to }) => from[0] !== to[0] && from[1] !== to[1]);
    expect(slopes).toHaveLength(2);
  });

  it('needs twice the strength for twice the load', () => {
    const once = ghostTruss(middleLoad(12, 4, 5), highs);
    const twice = ghostTruss(middleLoad(12, 4, 10), highs);
    expect(twice.volume).toBeCloseTo(2 * once.volume, 4);
  });

  it('is the same however often the truck is looked at: it holds wherever that is', () => {
    const rarely = middleLoad(12, 4, 5);
    const often = ghostTruss({ ...rarely, step: 1 }, highs);
    expect(often.volume).toBeCloseTo(ghostTruss(rarely, highs).volume, 6);
  });

  it('carries two axles no more easily than one of them', () => {
    const one = middleLoad(16, 4, 5);
    const two = { ...one, truck: { axles: [0, 6], forces: [5, 5], track: 0 } };
    expect(ghostTruss(two, highs).volume).toBeGreaterThan(ghostTruss(one, highs).volume);
  });

  it('becomes a drawing of legal lines on both sides, joined across', () => {
    const contest: BridgeContest = {
      ...BRIDGE_DEFAULTS,
      deck: { from: [0, 3, 4], to: [12, 3, 4] },
      step: 2,
    };
    const truss = ghostTruss(contest, highs);
    const { lines } = ghostSketch(contest, truss, 'Ghost');
    expect(lines.every((line) => Number.isInteger(lineLength(line)))).toBe(true);
    const ys = new Set(lines.flatMap(({ from, to }) => [from[1], to[1]]));
    expect([...ys].sort()).toEqual([1, 5]);
    const across = lines.filter(({ from, to }) => from[1] !== to[1]);
    expect(across.length).toBeGreaterThan(3);
    expect(across.every(({ from, to }) => from[0] === to[0] && from[2] === to[2])).toBe(true);
  });
});

it('decks of no whole length have none, and it is said', () => {
  const contest = middleLoad(12, 4, 5);
  expect(faultOfGhost(contest)).toBeNull();
  const odd = { ...contest, deck: { from: [0, 0, 4], to: [12.5, 0, 4] } as const };
  expect(faultOfGhost(odd)).toContain('whole length');
});

it('bars in line become one where they touch, and only there', () => {
  const bars = [
    [
      [4, 0],
      [2, 0],
    ],
    [
      [0, 0],
      [2, 0],
    ],
    [
      [6, 0],
      [8, 0],
    ],
    [
      [0, 2],
      [2, 2],
    ],
    [
      [0, 0],
      [0, 2],
    ],
  ] as const;
  expect(joinedBars(bars)).toEqual([
    [
      [0, 0],
      [4, 0],
    ],
    [
      [6, 0],
      [8, 0],
    ],
    [
      [0, 2],
      [2, 2],
    ],
    [
      [0, 0],
      [0, 2],
    ],
  ]);
});
