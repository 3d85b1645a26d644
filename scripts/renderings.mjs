// `npm run renderings [-- --only ID,ID]`: ten drawings that a builder knows, each solved as the first version did by
// default (preset `simple`) and as the program does now, drawn with the page's own renderer, and a page that shows
// both beside their figures: docs/renderings/. Looked at, not asserted: figures can be met by models that look wrong.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { figuresOf } from './lib/builder-figures.mjs';
import { drawParts } from './lib/gallery.mjs';
import { loadTypeScript } from './lib/load-typescript.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { capture, exitWith, StepError, TOP } from './lib/run.mjs';

const FOLDER = 'docs/renderings';
const BUILD = 'build/renderings';
const PICTURE = {
  size: { width: 480, height: 400, margin: 14 },
  colours: 64,
  style: { detail: 'high', smooth: 3, line: 0.4 },
};

/** Drawings, and what hurt a builder's eye when their models were last looked at: look again when they change. */
const DRAWINGS = [
  ['table', 'public/examples', ''],
  ['chair-side', 'public/gallery', 'something can still be moved.'],
  ['staircase', FOLDER, 'left and right differ, and the treads do not all lie alike.'],
  ['house', 'public/examples', 'a few heads under its roof sit in nothing.'],
  [
    'bridge',
    'public/examples',
    'its lower chords are in pieces that pass each other, and some heads sit in nothing.',
  ],
  ['tower', 'public/examples', 'one foot is in the air, and its middle bars lie on two heights.'],
  ['airplane', 'public/examples', 'left and right wing differ.'],
  ['crane', FOLDER, 'the jib is spliced at the mast, for the mirror’s sake.'],
  ['car', FOLDER, 'four of its feet are in the air, and left and right differ.'],
  ['castle', 'public/gallery', 'some of its beams can still be moved.'],
].map(([id, folder, hurts]) => ({ id, file: `${folder}/${id}.sketch.json`, hurts }));

/** `simple` was the default until there was `balanced`. */
const SIDES = [
  { id: 'before', preset: 'simple', title: 'Before: `simple`' },
  { id: 'after', preset: 'balanced', title: 'After: `balanced`' },
];

const { values: options } = parseArgs({
  options: { only: { type: 'string' }, 'no-build': { type: 'boolean', default: false } },
});

/** Solves one drawing and draws its model. @returns its report. */
function render(command, tools, drawing, side) {
  const out = resolve(TOP, BUILD, side.id);
  mkdirSync(out, { recursive: true });
  const args = ['solve', drawing.file, '-o', out, '--preset', side.preset, '--json'];
  const { code, stdout, stderr } = capture(command, args);
  if (code !== 0) {
    throw new StepError(`${drawing.file}, ${side.preset}: ${stderr || 'not buildable'}`);
  }
  const model = JSON.parse(readFileSync(resolve(out, `${drawing.id}.model.json`), 'utf8'));
  drawParts(resolve(TOP, FOLDER, `${drawing.id}-${side.id}.png`), model.parts, tools, PICTURE);
  return JSON.parse(stdout);
}

const percent = (part, whole) => `${whole > 0 ? ((100 * part) / whole).toFixed(1) : '0.0'} %`;

const ROWS = [
  ['well built', (r) => `${r.wellBuilt.passed} of ${r.wellBuilt.of}`],
  ['beams, parts, kinds', (r, f) => `${r.beams}, ${r.bricks}, ${f.kinds}`],
  ['layers off their lines, mean', (_, f) => f.meanLayer.toFixed(2)],
  ['below the base, feet in the air', (_, f) => `${f.belowBase}, ${f.liftedFeet}`],
  ['freedoms, beams on one line', (_, f) => `${f.freedomsBeyondJoints}, ${f.beamsOnOneAxis}`],
  ['heads in nothing', (_, f) => percent(f.nakedHeads, f.heads)],
  [
    'beams with their image',
    (_, f) => (f.items.symmetric.applies ? percent(f.mirroredBeams, f.beams) : '-'),
  ],
];

/** One drawing on the page: its pictures side by side, its figures below. */
function section({ id, file, hurts }, reports) {
  const figures = reports.map((report) => figuresOf(report.wellBuilt));
  const pictures = SIDES.map((side) => `![${id}, ${side.id}](${id}-${side.id}.png)`);
  return [
    `## ${id}`,
    '',
    `\`${file}\`, ${reports[0].lines} lines.`,
    '',
    `| | ${SIDES.map(({ title }) => title).join(' | ')} |`,
    '| --- | --- | --- |',
    `| | ${pictures.join(' | ')} |`,
    ...ROWS.map(
      ([title, of]) => `| ${title} | ${reports.map((r, i) => of(r, figures[i])).join(' | ')} |`,
    ),
    '',
    ...(hurts ? [`What still hurts: ${hurts}`, ''] : []),
  ];
}

function page(sections) {
  return [
    '# Ten drawings, before and after',
    '',
    'Made by `npm run renderings`; do not edit. Each drawing is solved twice, seed 1: with `simple`, what the first version took by default, and with',
    '`balanced`, the default now ([presets](../presets.md)); drawn with the page’s own renderer. The figures are those of [well built](../well-built.md).',
    '',
    ...sections.flat(),
  ].join('\n');
}

async function main() {
  const wanted = options.only?.split(',') ?? DRAWINGS.map(({ id }) => id);
  const command = await readyCommand(options['no-build'] ? 'build/native/liftarm' : undefined);
  const { tools } = await loadTypeScript('scripts/lib/gallery-tools.ts');
  mkdirSync(resolve(TOP, FOLDER), { recursive: true });
  const sections = [];
  for (const drawing of DRAWINGS.filter(({ id }) => wanted.includes(id))) {
    const reports = SIDES.map((side) => render(command, tools, drawing, side));
    console.log(
      `${drawing.id.padEnd(12)} ${reports.map((r) => `${r.beams} beams, ${r.wellBuilt.passed} of ${r.wellBuilt.of}`).join(' -> ')}`,
    );
    sections.push(section(drawing, reports));
  }
  // A choice of them is for looking: the page shows all or is left as it is.
  if (sections.length === DRAWINGS.length) {
    writeFileSync(resolve(TOP, FOLDER, 'README.md'), page(sections));
  }
}

main().catch(exitWith);
