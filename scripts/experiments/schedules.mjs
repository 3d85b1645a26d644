import { cubeSketch, gridSketch } from '../lib/families/families.mjs';
import { rounded, settings, yesNo } from './laboratory.mjs';
import { barPlot } from './plots.mjs';

const SCHEDULES = ['exponential', 'linear', 'logarithmic', 'optimum', 'thermodynamic'];
const VARIANTS = [
  ...SCHEDULES.map((name) => [
    name,
    ['--method', 'paper', ...settings([`paper.schedule=${name}`])],
  ]),
  ['population', ['--method', 'population']],
];
const TITLES = [
  'model',
  'schedule',
  'objective',
  'beams',
  'gaps',
  'collisions',
  'failed',
  'buildable',
];

export const schedules = {
  name: 'schedules',
  title: 'Cooling schedules and a population for the paper’s method',
  shows:
    'The paper’s method with its exponential schedule, with the four others that it names, and as a population of N = 20 and K = 4, on grids and a cube: objective, gaps and beams.',
  differs:
    'The paper reports "no obvious improvements" without figures. Each schedule has the moves of an exponential one of 0.9995 here, so that they cost alike; how each was read stands in core/rivals/schedules.h.',
  run(laboratory) {
    const sketches = laboratory.some(
      [gridSketch(2), cubeSketch(8), gridSketch(4), gridSketch(6)],
      1,
    );
    const slow = settings([`paper.coolingRate=${laboratory.quick ? 0.99 : 0.9995}`]);
    const runs = sketches.flatMap((sketch) =>
      VARIANTS.map(([schedule, args]) => ({
        model: sketch.name,
        schedule,
        report: laboratory.solve(`${sketch.name}, ${schedule}`, laboratory.fileOf(sketch), [
          ...['--preset', 'simple'],
          ...args,
          ...slow,
        ]),
      })),
    );
    const rows = runs.map(({ model, schedule, report: r }) => [
      ...[model, schedule, rounded(r.objective, 1), r.beams, r.gaps, r.collisions],
      ...[r.failedConnections, yesNo(r.buildable)],
    ]);
    const points = runs.map(({ model, schedule, report }) => ({
      x: model,
      y: report.beams,
      series: schedule,
    }));
    return {
      tables: [{ titles: TITLES, rows }],
      csv: { titles: TITLES, rows },
      plots: [
        { key: 'beams', caption: 'Beams', spec: barPlot(points, { x: 'model', y: 'beams' }) },
      ],
    };
  },
};
