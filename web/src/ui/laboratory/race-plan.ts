import type { SolveSettings } from '../../solver/protocol.ts';

// What races: sketches, methods, seed, moves and bricks, and the text of it in an address.

/** The methods of `liftarm solve --method`, by the names that it takes; the laboratory's module has them all. */
export const METHODS = [
  'default',
  'paper',
  'population',
  'ant-colony',
  'beam-search',
  'greedy',
  'random',
] as const;
export type MethodId = (typeof METHODS)[number];

/** How many moves a search makes: as many as usual, or a small part of them. */
export const MOVES = ['short', 'whole'] as const;
export type Moves = (typeof MOVES)[number];

/** All parts of ours, or the paper's: straight beams and the L of 3 by 5. */
export const BRICKS = ['paper', 'ours'] as const;
export type Bricks = (typeof BRICKS)[number];

export interface RacePlan {
  /** Ids of sketches.ts. */
  readonly sketches: readonly string[];
  readonly methods: readonly MethodId[];
  readonly seed: number;
  readonly moves: Moves;
  readonly bricks: Bricks;
}

export const FIRST_PLAN: RacePlan = Object.freeze({
  sketches: ['grid-1', 'grid-2', 'grid-3'],
  methods: ['default', 'paper', 'greedy'] as const,
  seed: 1,
  moves: 'short',
  bricks: 'paper',
});

export const MAX_SEED = 2 ** 31;
const MAX_SKETCHES = 40;
const SKETCH_ID = /^[a-z][a-z0-9-]{0,60}$/;

/** The paper's method cools by so much a step: the slower of its authors' rates for grids, and a quick one. */
const COOLING: Readonly<Record<Moves, number>> = { short: 0.995, whole: 0.9998 };
const EFFORT: Readonly<Record<Moves, number>> = { short: 0.1, whole: 1 };

/** What the solver is told for one method; the same as `npm run experiments grids` says on the command line. */
export function settingsOfRun(plan: RacePlan, method: MethodId): SolveSettings {
  const bricks =
    plan.bricks === 'paper' ? { bent: '32526', 'search.frames': 0, 'search.axles': 0 } : {};
  const moves =
    method === 'default' || plan.moves === 'short' ? { effort: EFFORT[plan.moves] } : {};
  return {
    seed: plan.seed,
    preset: 'simple',
    method,
    set: { ...bricks, ...moves, 'paper.coolingRate': COOLING[plan.moves] },
  };
}

/** Such as `grid-1.grid-2~default.paper~1~short~paper`. */
export function writePlan({ sketches, methods, seed, moves, bricks }: RacePlan): string {
  return [sketches.join('.'), methods.join('.'), seed, moves, bricks].join('~');
}

/** The plan of a text from an address; null where it is none. */
export function readPlan(text: string): RacePlan | null {
  const [sketches = '', methods = '', seed = '', moves, bricks, ...more] = text.split('~');
  const ids = [...new Set(sketches.split('.'))].filter((id) => id !== '');
  const named = METHODS.filter((method) => methods.split('.').includes(method));
  const number = Number(seed);
  const knownMoves = MOVES.find((one) => one === moves);
  const knownBricks = BRICKS.find((one) => one === bricks);
  const readable =
    more.length === 0 &&
    ids.every((id) => SKETCH_ID.test(id)) &&
    ids.length <= MAX_SKETCHES &&
    /^\d+$/.test(seed) &&
    number <= MAX_SEED;
  return readable && knownMoves && knownBricks
    ? { sketches: ids, methods: named, seed: number, moves: knownMoves, bricks: knownBricks }
    : null;
}

/** A list with a thing taken in or left out, in the order of `all`. */
export function toggled<T>(all: readonly T[], chosen: readonly T[], one: T): T[] {
  return all.filter((other) => (other === one ? !chosen.includes(one) : chosen.includes(other)));
}
