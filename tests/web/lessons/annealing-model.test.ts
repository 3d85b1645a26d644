import { describe, expect, it } from 'vitest';
import {
  makeRandom,
  randomState,
  TOY,
  TOY_BEAMS,
  troubleOf,
  tryMove,
} from '../../../web/src/ui/lessons/annealing-model.ts';

function run(seed: number, temperatures: (share: number) => number, tries: number): number {
  const random = makeRandom(seed);
  const layers = randomState(random);
  for (let i = 0; i < tries && troubleOf(layers) > 0; i++) {
    tryMove(layers, temperatures(i / tries), random);
  }
  return troubleOf(layers);
}

const SEEDS = [1, 2, 3, 4, 5, 6, 7, 8];

describe('the toy of the annealing lesson', () => {
  it('has no trouble when columns lie between the halves of the rows', () => {
    const layers = Array.from({ length: TOY_BEAMS }, (_, beam) =>
      beam < TOY.rows ? 0 : beam < 2 * TOY.rows ? 2 : 1,
    );
    expect(troubleOf(layers)).toBe(0);
  });

  it('gets stuck cold from some beginnings', () => {
    const stuck = SEEDS.filter((seed) => run(seed, () => 0, 8000) > 0);
    expect(stuck.length).toBeGreaterThanOrEqual(2);
  });

  it('is solved by slow cooling more often than cold', () => {
    const cooled = SEEDS.filter((seed) => run(seed, (s) => 15 * 0.001 ** s, 15_000) === 0);
    const cold = SEEDS.filter((seed) => run(seed, () => 0, 15_000) === 0);
    expect(cooled.length).toBeGreaterThan(cold.length);
  });
});
