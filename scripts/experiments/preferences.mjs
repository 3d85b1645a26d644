import { mkdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { drawParts } from '../lib/gallery.mjs';
import { loadTypeScript } from '../lib/load-typescript.mjs';
import { TOP } from '../lib/run.mjs';
import { rounded, yesNo } from './laboratory.mjs';

const PRESETS = ['faithful', 'simple', 'simple-rigid', 'balanced'];
const SKETCHES = [
  ['cube', 'public/examples/cube.sketch.json'],
  ['long-bow', 'public/gallery/long-bow.sketch.json'],
  ['airplane', 'public/examples/airplane.sketch.json'],
  ['tower-2d', 'public/gallery/small-tower-2d.sketch.json'],
];
const PICTURE = {
  size: { width: 320, height: 240, margin: 12 },
  colours: 64,
  style: { detail: 'high', smooth: 3, line: 0.34 },
};
const TITLES = [
  'model',
  'preset',
  'beams',
  'bricks',
  'mean layer',
  'deviation',
  'pin-head ratio',
  'rigid subsets',
  'loose',
  'buildable',
];

function rowOf(name, preset, report) {
  const faithful = report.wellBuilt.items.find(({ id }) => id === 'faithful');
  return [
    name,
    preset,
    report.beams + report.axles,
    report.bricks,
    rounded(faithful?.figures.meanLayer),
    rounded(report.deviation),
    rounded(report.pinHeadRatio),
    report.rigidSubsets,
    report.freedomsBeyondJoints,
    yesNo(report.buildable),
  ];
}

function pictureTable(names) {
  const cell = (name, preset) => `![${name}, ${preset}](pictures/${name}-${preset}.png)`;
  return {
    titles: ['', ...PRESETS],
    rows: names.map((name) => [name, ...PRESETS.map((preset) => cell(name, preset))]),
  };
}

export const preferences = {
  name: 'preferences',
  title: 'Preferences side by side',
  shows:
    'The same drawing made with emphasis on faithfulness, on few beams, on few beams and stiffness, and on all at once (the default): one row each with pictures.',
  differs:
    'The paper weighs the deviation, total beam length and local rigidity; ours counts freedoms of the whole model with every pin turning ("loose"), and its default wants everything at once. Layers off the line are a mean over beams beside the paper’s root of mean squares.',
  async run(laboratory, out) {
    const { tools } = await loadTypeScript('scripts/lib/gallery-tools.ts');
    mkdirSync(resolve(out, 'pictures'), { recursive: true });
    const sketches = laboratory.some(SKETCHES, 1);
    const rows = sketches.flatMap(([name, file]) =>
      PRESETS.map((preset) => {
        const args = ['--preset', preset];
        const { report, model } = laboratory.solveModel(
          `${name}, ${preset}`,
          resolve(TOP, file),
          args,
        );
        const picture = resolve(out, 'pictures', `${name}-${preset}.png`);
        drawParts(picture, model.parts, tools, PICTURE);
        return rowOf(name, preset, report);
      }),
    );
    return {
      tables: [pictureTable(sketches.map(([name]) => name)), { titles: TITLES, rows }],
      csv: { titles: TITLES, rows },
    };
  },
};
