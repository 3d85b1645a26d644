import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { TOP } from '../lib/run.mjs';
import { rounded, yesNo } from './laboratory.mjs';

const GALLERY = resolve(TOP, 'public/gallery');
const FIGURES = resolve(TOP, 'scripts/experiments/papers-sketches.json');

const TITLES = [
  'model',
  'lines',
  'length',
  'components',
  'beams',
  'bricks',
  'size (modules)',
  'loose',
  'buildable',
  "lines of the paper's",
  "length of the paper's",
];

function rowOf(id, report, papers) {
  return [
    id,
    report.lines,
    report.length,
    report.components,
    report.beams,
    report.bricks,
    report.size.map((x) => rounded(x, 1)).join(' x '),
    report.freedomsBeyondJoints,
    yesNo(report.buildable),
    papers?.lines ?? '-',
    papers?.length ?? '-',
  ];
}

export const statistics = {
  name: 'statistics',
  title: 'Statistics of the gallery',
  shows:
    'Size of each drawing of the gallery and of the model that the default setting finds for it, as in the paper’s table of 24 models.',
  differs:
    'The drawings are our own, so only their kind compares; where the paper’s sketch of that name is public, its lines and length stand beside ours. Ours knows bent beams, frames and axles along lines; "loose" (freedoms beyond the joints) is not in the paper.',
  run(laboratory) {
    const { models } = JSON.parse(readFileSync(resolve(GALLERY, 'index.json'), 'utf8'));
    const { sketches } = JSON.parse(readFileSync(FIGURES, 'utf8'));
    const rows = laboratory.some(models, 2).map(({ id, file }) => {
      const report = laboratory.solve(id, resolve(GALLERY, file), []);
      return rowOf(id, report, sketches[id]);
    });
    return { tables: [{ titles: TITLES, rows }], csv: { titles: TITLES, rows } };
  },
};
