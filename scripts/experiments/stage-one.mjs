import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { TOP } from '../lib/run.mjs';
import { rounded } from './laboratory.mjs';

const GALLERY = resolve(TOP, 'public/gallery');
const TITLES = [
  'model',
  'nodes',
  'random (mean of 100)',
  'random (least)',
  'paper',
  'ours',
  'components, paper',
  'components, ours',
];

export const stageOne = {
  name: 'stage-one',
  title: 'Stage one: hole axes before and after',
  shows:
    'Adjacent nodes whose holes point in different directions: for hole axes taken at random, after the paper’s annealing, and after ours with its many starts; and the coplanar components that result.',
  differs:
    'The paper shows three examples with random starts; here all of the gallery. Ours minimises the number of different axes at each junction less one, which is not quite the paper’s count, but all columns are counted as the paper does.',
  run(laboratory) {
    const { models } = JSON.parse(readFileSync(resolve(GALLERY, 'index.json'), 'utf8'));
    const rows = laboratory.some(models, 4).map(({ id, file }) => {
      const {
        nodes,
        random,
        paper,
        default: ours,
      } = laboratory.tell('stage-one', resolve(GALLERY, file), ['--seed', `${laboratory.seed}`]);
      return [
        ...[id, nodes, rounded(random.differences), random.least],
        ...[paper.differences, ours.differences, paper.components, ours.components],
      ];
    });
    return { tables: [{ titles: TITLES, rows }], csv: { titles: TITLES, rows } };
  },
};
