import { describe, expect, it } from 'vitest';
import {
  BRICKS,
  FIRST_PLAN,
  METHODS,
  MOVES,
  type RacePlan,
  readPlan,
  settingsOfRun,
  toggled,
  writePlan,
} from '../../../../web/src/ui/laboratory/race-plan.ts';

describe('the plan of a race in an address', () => {
  it('is read as it was written', () => {
    for (const moves of MOVES) {
      for (const bricks of BRICKS) {
        const plan: RacePlan = {
          sketches: ['mine-2', 'grid-10', 'square-frame'],
          methods: METHODS,
          seed: 7,
          moves,
          bricks,
        };
        expect(readPlan(writePlan(plan))).toEqual(plan);
      }
    }
  });

  it('may hold nothing to race', () => {
    const plan: RacePlan = { ...FIRST_PLAN, sketches: [], methods: [] };
    expect(readPlan(writePlan(plan))).toEqual(plan);
  });

  it('leaves out methods that are not known', () => {
    expect(readPlan('grid-1~default.magic~1~short~paper')?.methods).toEqual(['default']);
  });

  it.each([
    '',
    'grid-1',
    'grid-1~default~1~short',
    'grid-1~default~1~short~paper~more',
    'grid-1~default~-1~short~paper',
    'grid-1~default~1.5~short~paper',
    'grid-1~default~9999999999~short~paper',
    'grid-1~default~1~long~paper',
    'grid-1~default~1~short~wood',
    '../x~default~1~short~paper',
    `${Array.from({ length: 41 }, (_, i) => `grid-${i}`).join('.')}~default~1~short~paper`,
  ])('is not read from %s', (text) => {
    expect(readPlan(text)).toBeNull();
  });
});

it('a thing is taken in at its place, and left out again', () => {
  const all = ['a', 'b', 'c'];
  expect(toggled(all, ['c'], 'a')).toEqual(['a', 'c']);
  expect(toggled(all, ['a', 'c'], 'a')).toEqual(['c']);
});

it('a whole search of the paper’s bricks is the one of the experiment on grids', () => {
  const plan: RacePlan = { ...FIRST_PLAN, moves: 'whole', bricks: 'paper' };
  expect(settingsOfRun(plan, 'paper')).toEqual({
    seed: 1,
    preset: 'simple',
    method: 'paper',
    set: { bent: '32526', 'search.frames': 0, 'search.axles': 0, 'paper.coolingRate': 0.9998 },
  });
});
