import { resolve } from 'node:path';
import { cubeSketch, scaled } from '../lib/families/families.mjs';
import { fitPower } from '../lib/power-fit.mjs';
import { TOP } from '../lib/run.mjs';
import { rounded, yesNo } from './laboratory.mjs';
import { linePlot } from './plots.mjs';

const SIDES = [4, 8, 12, 16, 20, 24, 32, 40, 56, 80];
const FACTORS = [1, 2, 3, 4, 6, 8];
const METHODS = [
  ['ours', []],
  ['paper', ['--method', 'paper', '--preset', 'simple', '--set', 'paper.coolingRate=0.9995']],
];
const TITLES = ['family', 'times', 'length', 'method', 'beams', 'bricks', 'gaps', 'buildable'];

function sketches(laboratory) {
  const kite = laboratory.read(resolve(TOP, 'public/gallery/flying-kite.sketch.json'));
  return [
    ...laboratory
      .some(SIDES, 2)
      .map((side) => ({ family: 'cube', times: side, sketch: cubeSketch(side) })),
    ...laboratory.some(FACTORS, 2).map((times) => ({
      family: 'kite',
      times,
      sketch: scaled(kite, times),
    })),
  ];
}

function fitRow(points, family, method) {
  const fit = fitPower(points.filter((p) => p.family === family && p.method === method));
  return [family, method, rounded(fit?.exponent), rounded(fit?.rSquared)];
}

function fits(points) {
  const rows = ['cube', 'kite'].flatMap((family) =>
    METHODS.map(([method]) => fitRow(points, family, method)),
  );
  return { titles: ['family', 'method', 'exponent', 'R squared'], rows };
}

function plot(points, y) {
  const series = points.map((p) => ({ x: p.x, y: p.y, series: `${p.family}, ${p.method}` }));
  return linePlot(series, { x: 'length of lines (modules)', y, logarithmic: true });
}

export const scalability = {
  name: 'scalability',
  title: 'Scalability: cube and kite in growing sizes',
  shows:
    'How beams (here) and seconds (in times/) grow with the length of the drawing, for a cube and a kite enlarged step by step, with the exponent of a power law fitted to each.',
  differs:
    'The paper says "roughly linearly" for its four or five sizes; ours go to drawings twenty times as long. The kite is our own drawing. The paper’s method cools by 0.9995 at all sizes, so that it is one method throughout.',
  run(laboratory) {
    const slow = laboratory.quick ? ['--set', 'paper.coolingRate=0.99'] : [];
    const runs = sketches(laboratory).flatMap(({ family, times, sketch }) =>
      METHODS.map(([method, args]) => {
        const name = `${family} ${times}, ${method}`;
        const report = laboratory.solve(name, laboratory.fileOf(sketch), [...args, ...slow]);
        return { family, times, method, report, seconds: laboratory.times.at(-1).seconds };
      }),
    );
    const points = (of) =>
      runs.map((run) => ({ ...run, x: run.report.length, y: Math.max(0.001, of(run)) }));
    const beams = points(({ report }) => report.beams + report.axles);
    const seconds = points((run) => run.seconds);
    const rows = runs.map(({ family, times, method, report: r }) => [
      ...[family, times, r.length, method, r.beams + r.axles, r.bricks, r.gaps],
      yesNo(r.buildable),
    ]);
    const secondsFits = fits(seconds).rows.map(([family, method, exponent, rSquared]) => ({
      run: `fit of ${family}, ${method}: exponent ${exponent}, R squared ${rSquared}`,
      seconds: null,
    }));
    laboratory.times.push(...secondsFits);
    return {
      tables: [
        { caption: 'Beams grow with length to the power of', ...fits(beams) },
        { titles: TITLES, rows },
      ],
      csv: { titles: TITLES, rows },
      plots: [{ key: 'beams', caption: 'Beams by length', spec: plot(beams, 'beams') }],
      timePlots: [{ key: 'seconds', caption: 'Seconds by length', spec: plot(seconds, 'seconds') }],
    };
  },
};
