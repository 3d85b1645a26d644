// All experiments, in the order of the paper's section on results.
import { brickSets } from './brick-sets.mjs';
import { grids } from './grids.mjs';
import { joints } from './joints.mjs';
import { preferences } from './preferences.mjs';
import { puzzle } from './puzzle.mjs';
import { scalability } from './scalability.mjs';
import { schedules } from './schedules.mjs';
import { stageOne } from './stage-one.mjs';
import { statistics } from './statistics.mjs';
import { weights } from './weights.mjs';

export const EXPERIMENTS = [
  stageOne,
  statistics,
  scalability,
  brickSets,
  grids,
  puzzle,
  preferences,
  weights,
  joints,
  schedules,
];
