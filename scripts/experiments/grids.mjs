import loadHighs from 'highs';
import { faultOf } from '../check-certificate.mjs';
import { gridSketch } from '../lib/families/families.mjs';
import { loadTypeScript } from '../lib/load-typescript.mjs';
import { StepError } from '../lib/run.mjs';
import { PAPERS_BRICKS, rounded, settings, yesNo } from './laboratory.mjs';
import { linePlot } from './plots.mjs';

const SIMPLE = ['--preset', 'simple'];
const SIZES = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10];
/** Quick runs take a twentieth of the moves. */
const LITTLE = settings(['effort=0.05', 'paper.coolingRate=0.99']);

/** Each with the arguments of `liftarm solve`. */
const METHODS = [
  ['random', ['--method', 'random']],
  ['greedy', ['--method', 'greedy']],
  ['beam search', ['--method', 'beam-search']],
  ['ant colony', ['--method', 'ant-colony']],
  // The slower of the two rates that its authors' own program has in its settings for grids.
  ['paper', ['--method', 'paper', ...settings(['paper.coolingRate=0.9998'])]],
  ['ours, its bricks', PAPERS_BRICKS],
  ['ours', []],
];

/** Straight beams alone, of at most 15 holes: each of the 2 (n + 1) lines has 4n edges. */
function straightOptimum(n) {
  return 2 * (n + 1) * Math.ceil((4 * n) / 14);
}

/** A proved lower bound on beams for a sketch and its settings; certificates are checked. */
export async function provedBound(laboratory, sketch, args) {
  const { prove } = await loadTypeScript('web/src/solver/proof/prove.ts');
  const placements = laboratory.tell('placements', sketch, args);
  // Leaves are counted, so that the bound is the same on any machine; seconds are no limit.
  const certificate = prove(placements, await loadHighs(), { seconds: 3600, leaves: 200 });
  const fault = faultOf(placements, certificate);
  if (fault !== null) {
    throw new StepError(`${sketch}: the certificate is wrong: ${fault}`);
  }
  return certificate.bound;
}

function measure(laboratory, n, [method, args]) {
  const sketch = laboratory.fileOf(gridSketch(n));
  const slow = laboratory.quick ? LITTLE : [];
  const report = laboratory.solve(`grid ${n}, ${method}`, sketch, [...SIMPLE, ...args, ...slow]);
  return { n, method, report };
}

function tableOf(caption, cells, { sizes, columns, of }) {
  const names = METHODS.map(([method]) => method);
  const rows = sizes.map((n) => [
    n,
    ...names.map((method) => of(cells.find((cell) => cell.n === n && cell.method === method))),
    ...columns.map(([, value]) => value(n)),
  ]);
  return { caption, titles: ['n', ...names, ...columns.map(([title]) => title)], rows };
}

function plotOf(cells, y, of) {
  const points = cells.map((cell) => ({ x: cell.n, y: of(cell), series: cell.method }));
  return linePlot(points, { x: 'cells a side', y });
}

const gapsOf = ({ report }) => report.gaps;
const beamsOf = ({ report }) => report.beams + report.axles;
const faultsOf = ({ report }) =>
  `${report.collisions} / ${report.failedConnections} / ${yesNo(report.buildable)}`;

export const grids = {
  name: 'grids',
  title: 'Grids: rivals, the paper’s method, ours, and the optimum',
  shows:
    'Gaps and beams of layouts for n by n grids of cells 4 by 4, where the longest beams lead to gaps: what the paper compares its method with, its method, and ours beside the fewest beams that can be.',
  differs:
    'All methods run on our data structures, with our reading of each (heads of core/rivals/*.h); the paper’s cools by 0.9998, the slower rate of its authors for grids. Ours is shown with the paper’s bricks (straight beams and the L of 3 by 5) and with all of ours; the lower bound in the last column is proved for all of ours by integer programming with a checked certificate, that of straight beams by counting. A gap that a one-hole beam fills as a spacer counts as a gap here; layouts of the rivals are joined at the end, so theirs may also collide or fail to connect. Greedy begins with L beams, which cover most, and in two of three ways they leave no room for the rest: so it may fail even at n = 1.',
  async run(laboratory) {
    const sizes = laboratory.some(SIZES, 2);
    const cells = sizes.flatMap((n) => METHODS.map((method) => measure(laboratory, n, method)));
    const bounds = new Map();
    for (const n of sizes) {
      const sketch = laboratory.fileOf(gridSketch(n));
      bounds.set(n, await provedBound(laboratory, sketch, SIMPLE));
    }
    const optima = [
      ['straight optimum', straightOptimum],
      ['bound, all bricks', (n) => bounds.get(n)],
    ];
    const titles = ['n', 'method', 'gaps', 'beams', 'bricks', 'collisions', 'failed', 'buildable'];
    const rows = cells.map(({ n, method, report: r }) => [
      ...[n, method, r.gaps, r.beams + r.axles, r.bricks],
      ...[r.collisions, r.failedConnections, yesNo(r.buildable)],
    ]);
    const seconds = cells.map((cell, i) => ({
      x: cell.n,
      y: Math.max(0.001, Number(rounded(laboratory.times[i].seconds, 3))),
      series: cell.method,
    }));
    return {
      tables: [
        tableOf('Gaps', cells, { sizes, columns: [], of: gapsOf }),
        tableOf('Beams', cells, { sizes, columns: optima, of: beamsOf }),
        tableOf('Collisions / failed connections / buildable', cells, {
          sizes,
          columns: [],
          of: faultsOf,
        }),
      ],
      csv: { titles, rows },
      plots: [
        { key: 'gaps', caption: 'Gaps by size', spec: plotOf(cells, 'gaps', gapsOf) },
        { key: 'beams', caption: 'Beams by size', spec: plotOf(cells, 'beams', beamsOf) },
      ],
      timePlots: [
        {
          key: 'seconds',
          caption: 'Seconds by size',
          spec: linePlot(seconds, { x: 'cells a side', y: 'seconds', logarithmic: true }),
        },
      ],
    };
  },
};
