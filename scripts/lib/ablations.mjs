// The parts of the search that can be switched off, and what a row of the table of ablations says.

import { geometricMean } from './markdown.mjs';
import { median } from './statistics.mjs';

/** The whole search first; then one part at a time. `set` is what `liftarm solve --set` takes. */
export const ABLATIONS = [
  { key: 'nothing', title: 'nothing', set: [], about: 'the whole search.' },
  {
    key: 'corners',
    title: 'bent beams',
    set: ['search.corners=0'],
    about: 'straight beams and frames only.',
  },
  {
    key: 'frames',
    title: 'frames',
    set: ['search.frames=0'],
    about: 'no frame covers lines: straight and bent beams only.',
  },
  {
    key: 'axle-lines',
    title: 'axles along lines',
    set: ['search.axles=0'],
    about: 'no axle covers a line.',
  },
  {
    key: 'focus',
    title: 'focus',
    set: ['search.focus=0'],
    about: 'runs are picked anywhere, not mostly where something is violated.',
  },
  {
    key: 'pairs',
    title: 'pairs',
    set: ['search.pairs=0'],
    about: 'a move never covers a second run that meets the first.',
  },
  {
    key: 'many',
    title: 'ruin and recreate',
    set: ['search.many=0'],
    about: 'several runs are never cleared at once.',
  },
  {
    key: 'turns',
    title: 'turns',
    set: ['search.turns=0'],
    about: 'hole axes stay as stage one chose them.',
  },
  {
    key: 'noise',
    title: 'noise',
    set: ['search.noise=0'],
    about: 'each proposal is the cheapest cover, without random amounts on its costs.',
  },
  {
    key: 'growth',
    title: 'growing weights',
    set: ['search.growth=0'],
    about: 'violations that stay do not gain weight.',
  },
  {
    key: 'walls',
    title: 'walls',
    set: ['search.walls=0'],
    about: 'the first layout lays one run after the other, each where it is cheapest.',
  },
  {
    key: 'mirrors',
    title: 'mirror moves',
    set: ['search.mirrors=0'],
    about: 'no move mirrors the layers of a run and lets what crosses it follow.',
  },
  {
    key: 'costly',
    title: 'costly runs first',
    set: ['search.costly=0'],
    about: 'runs with more beams than they need are not picked more often.',
  },
  {
    key: 'axles',
    title: 'axles with stops',
    set: ['connectors=2780,6558,87082,48989,55615,18654'],
    about: 'no axle with stop and bush: a stack holds three beams, and no axle covers a line.',
  },
  {
    key: 'spacers',
    title: 'spacers',
    set: ['connectors=2780,6558,87082,48989,55615,15462,3713'],
    about: 'no one-hole beam fills a gap in a stack.',
  },
  {
    key: 'starts',
    title: 'many starts',
    set: ['starts=1'],
    about: 'stage one is run once instead of 60 times.',
  },
  {
    key: 'rounds',
    title: 'further rounds',
    set: ['rounds=0'],
    about: 'the search ends after one round, also with violations.',
  },
  {
    key: 'mechanisms',
    title: 'mechanisms of two parts',
    set: ['mechanismParts=1'],
    about: 'single connecting parts only.',
  },
  {
    key: 'bent',
    title: '48989 and 55615',
    set: ['connectors=2780,6558,87082,15462,3713,18654'],
    about: 'no connectors that are corners by themselves.',
  },
];

/**
 * Parts that only some settings use, each judged by what it is for.
 * @type {{title: string, about: string, sketches: string[], symmetric: boolean, args: string[],
 *     good: string, isGood: (report: Record<string, any>) => boolean,
 *     rows: {key: string, title: string, set: string[], about: string}[]}[]}
 */
export const AIMS = [
  {
    title: 'Rigid presets',
    about: 'preset simple-rigid; stiff: buildable, and no freedom is left with all pins turning',
    sketches: ['cube_3', 'cube_5', 'cube_19', 'grid_4', 'grid_7', 'grid_8', 'house'],
    symmetric: false,
    args: ['--preset', 'simple-rigid'],
    good: 'stiff',
    isGood: (report) => report.buildable && report.freedoms === 0,
    rows: [
      {
        key: 'bends',
        title: 'bent beams',
        set: ['search.corners=0'],
        about: 'straight beams only.',
      },
    ],
  },
  {
    title: 'Confirmed symmetries',
    about:
      'mirrors across principal planes, confirmed; symmetric: buildable, and every line is its image',
    sketches: ['crossbow', 'cube_5', 'cube_9', 'fan', 'letter_H', 'picker', 'tower_3d_storey'],
    symmetric: true,
    args: [],
    good: 'symmetric',
    isGood: (report) => report.buildable && report.symmetryDeviation === 0,
    rows: [
      {
        key: 'orbits',
        title: 'covers of all images at once',
        set: ['search.orbits=0'],
        about: 'symmetry is not kept by the moves.',
      },
    ],
  },
];

/**
 * What the runs of one row come to.
 * @param {{sketch: string, report: Record<string, any> | null}[]} runs
 * @param {{sketch: string, report: Record<string, any> | null}[]} others runs of the same sketches and seeds
 *     in the same order: bricks are taken over those that are buildable in both.
 */
export function summariseAblation(runs, others) {
  const good = runs.filter(({ report }) => report?.buildable);
  const over = good
    .filter(({ report }) => report.beamsLowerBound > 0)
    .map(({ report }) => 100 * (report.beams / report.beamsLowerBound - 1));
  const inBoth = runs.filter(({ report }, i) => report?.buildable && others[i]?.report?.buildable);
  const bad = runs.filter(({ report }) => !report?.buildable).map(({ sketch }) => sketch);
  return {
    runs: runs.length,
    buildable: good.length,
    overBound: over.length > 0 ? over.reduce((sum, x) => sum + x, 0) / over.length : null,
    bricks: geometricMean(inBoth.map(({ report }) => report.bricks)),
    seconds: median(runs.map(({ report }) => report?.seconds.processor ?? Number.NaN)),
    slowest: Math.max(...runs.map(({ report }) => report?.seconds.processor ?? Number.NaN)),
    unreliable: [...new Set(bad)],
  };
}
