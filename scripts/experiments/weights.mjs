import { resolve } from 'node:path';
import { TOP } from '../lib/run.mjs';
import { withSymmetries } from '../lib/symmetric-sketch.mjs';
import { rounded, settings } from './laboratory.mjs';

/** Default weights: the paper's (4.3) as core/objective/objective.cpp has them, and ours for `simple`. */
const METHODS = [
  {
    method: 'paper',
    args: ['--method', 'paper', '--preset', 'simple'],
    weights: { cpt: 1, sym: 30, phr: 10, col: 30, gap: 100, coh: 50 },
  },
  {
    method: 'ours',
    args: ['--preset', 'simple'],
    weights: { beams: 10, holes: 0.05, layers: 0.02, overhang: 2, hinges: 3, connections: 1 },
  },
];
const MODELS = ['public/gallery/flying-kite.sketch.json', 'public/examples/airplane.sketch.json'];
const TITLES = [
  'model',
  'method',
  'term',
  'weight',
  'beams',
  'layer range',
  'asymmetry',
  'pin-head ratio',
  'collisions',
  'gaps',
  'failed',
];

function variants(weights) {
  return [
    { term: 'default', weight: '-', pairs: [] },
    ...Object.entries(weights).flatMap(([term, weight]) => [
      { term, weight: 'null', pairs: [`weights.${term}=0`] },
      { term, weight: 'x2', pairs: [`weights.${term}=${2 * weight}`] },
    ]),
  ];
}

function rowsOf(laboratory, file, { method, args, weights }) {
  const slow = laboratory.quick ? ['paper.coolingRate=0.99'] : [];
  return variants(weights).map(({ term, weight, pairs }) => {
    const name = file.split('/').at(-1).replace('.sketch.json', '');
    const all = [...args, ...settings([...pairs, ...slow])];
    const r = laboratory.solve(`${name}, ${method}, ${term} ${weight}`, file, all);
    return [
      ...[name, method, term, weight, r.beams + r.axles, r.layerRange],
      ...[rounded(r.symmetryDeviation, 3), rounded(r.pinHeadRatio), r.collisions, r.gaps],
      r.failedConnections,
    ];
  });
}

export const weights = {
  name: 'weights',
  title: 'Ablation of the objective’s terms',
  shows:
    'Each weight set to nought and doubled, one at a time, on two models with their mirrors confirmed: for the paper’s method the six terms of its table, for ours those that it weighs.',
  differs:
    'Ours has no weights for symmetry, collisions, gaps and connections: symmetry is kept by every move and the rest are conditions, so they cannot be traded. Models are our own drawings.',
  run(laboratory) {
    const files = laboratory
      .some(MODELS, 1)
      .map((file) => withSymmetries(laboratory.command, resolve(TOP, file)).file);
    const methods = laboratory.quick
      ? METHODS.map((one) => ({
          ...one,
          weights: Object.fromEntries(Object.entries(one.weights).slice(0, 2)),
        }))
      : METHODS;
    const rows = files.flatMap((file) =>
      methods.flatMap((method) => rowsOf(laboratory, file, method)),
    );
    return { tables: [{ titles: TITLES, rows }], csv: { titles: TITLES, rows } };
  },
};
