// `npm run compare [-- SKETCH...]`: the paper's method and ours on the same sketches, with the figures of the
// authors' own program beside them, as docs/methods.md.
import { writeFileSync } from 'node:fs';
import { relative, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { figures, geometricMean, markdownTable, secondsText } from './lib/markdown.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { exitWith, StepError } from './lib/run.mjs';
import {
  machine,
  referenceRuns,
  sketchFiles,
  sketchName,
  solve,
  wholeNumber,
} from './lib/solve.mjs';
import { inPapersCount } from './lib/statistics.mjs';

const USAGE = `npm run compare [-- SKETCH... options]
  SKETCH         a file or a name in ../shared/sketches; without any: all of ../shared/reference-runs.json
  --seed N       seed of both methods (default 1)
  --timeout S    seconds after which a run of either method is stopped (default 300)
  --out FILE     default docs/methods.md
  --command FILE the command to run (default build/native/liftarm, built first)`;

function readOptions() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      seed: { type: 'string', default: '1' },
      timeout: { type: 'string', default: '300' },
      out: { type: 'string', default: 'docs/methods.md' },
      command: { type: 'string' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help) {
    throw new StepError(USAGE);
  }
  return {
    names: positionals,
    seed: wholeNumber('seed', values.seed),
    timeoutMs: wholeNumber('timeout', values.timeout) * 1000,
    out: resolve(values.out),
    command: values.command,
  };
}

/** The paper's method cools as its authors set it for the sketch, where we know how. */
function paperArgs(reference) {
  const rate = reference?.coolingRate;
  return ['--method', 'paper', ...(rate ? ['--set', `paper.coolingRate=${rate}`] : [])];
}

function measure(file, reference, { command, seed, timeoutMs }) {
  const run = (args) =>
    solve(command, { sketch: file, args: ['--seed', `${seed}`, ...args], timeoutMs });
  const [ours, paper] = [run([]), run(paperArgs(reference))];
  const row = { name: sketchName(file), reference, ours, paper };
  console.log(cellsOf(row).join('  '));
  return row;
}

function authorsCell(reference) {
  if (reference === undefined) {
    return '-';
  }
  const { beams, bricks, gaps, collidingHoles, failedGroups } = reference;
  return figures({
    beams,
    bricks,
    gaps,
    collisions: collidingHoles,
    failedConnections: failedGroups,
  });
}

function runCells(report) {
  return report === null
    ? ['stopped', '-', '-']
    : [
        figures(inPapersCount(report)),
        report.buildable ? 'yes' : 'no',
        secondsText(report.seconds.processor),
      ];
}

function cellsOf({ name, reference, ours, paper }) {
  const known = ours ?? paper;
  return [
    name,
    known?.lines ?? '-',
    known?.beamsLowerBound ?? '-',
    ...runCells(ours),
    ...runCells(paper),
    authorsCell(reference),
    secondsText(reference?.searchSeconds),
  ];
}

const TITLES = [
  'sketch',
  'lines',
  'bound',
  'default',
  'buildable',
  'seconds',
  'paper',
  'buildable',
  'seconds',
  "authors' program",
  'seconds',
];

function summary(rows) {
  const built = (key) => rows.filter((row) => row[key]?.buildable).length;
  const ratio = (slow, fast) => geometricMean(rows.map((row) => slow(row) / fast(row)));
  const seconds = (key) => (row) => row[key]?.seconds.processor ?? Number.NaN;
  const beams = (key) => (row) => row[key]?.beams ?? Number.NaN;
  const text = (value) => (value === null ? '-' : value.toFixed(2));
  const total = (of) => rows.reduce((sum, { ours }) => sum + (ours ? of(ours) : 0), 0);
  const gaps = (report) => inPapersCount(report).gaps;
  const filled = (report) => report.filledGaps;
  const authors = (row) => row.reference?.searchSeconds ?? Number.NaN;
  return [
    `- Buildable: default ${built('ours')}, paper ${built('paper')}, of ${rows.length} sketches.`,
    `- Seconds, geometric means: paper / default ${text(ratio(seconds('paper'), seconds('ours')))}, ` +
      `authors' program / default ${text(ratio(authors, seconds('ours')))}.`,
    `- Gaps of the default, of which a spacer fills: ${total(gaps)}, ${total(filled)}; of the authors' program: ` +
      `${rows.reduce((sum, { reference }) => sum + (reference?.gaps ?? 0), 0)}.`,
    `- Beams, geometric mean: paper / default ${text(ratio(beams('paper'), beams('ours')))}.`,
  ].join('\n');
}

function documentOf(rows, { seed, machineText }) {
  return `# The paper's method against ours

Made by \`npm run compare\`; do not edit. ${machineText}; one thread, seed ${seed}.

A cell reads beams / bricks / gaps / collisions / failed connections. Gaps are counted as the paper does: empty layers in
stacks, those that a one-hole beam fills as a spacer among them (the paper knows no spacers; ours are in the bricks, and the last line
below counts them apart). **default** is our search with its one
default setting. **paper** is the method of Xu, Hui, Fu and Zhang, "Computational LEGO Technic Design" (ACM TOG
38(6), 2019), on our data structures (\`liftarm solve --method paper\`; \`core/search/paper_search.h\` lists how we
read it), with the cooling rate that its authors set for the sketch. **authors' program** are figures measured
with their own program, tuned per model by them, on a like machine; it counts colliding holes and failed groups,
and whether a person could build the result was not judged. Seconds are of the processor, for the search alone. "Buildable" is what \`liftarm check\` says. Bound: fewest beams of any layout with no more axles along lines ([lower bound](lower-bound.md)).

${markdownTable(TITLES, rows.map(cellsOf))}

${summary(rows)}
`;
}

async function main() {
  const options = readOptions();
  options.command = await readyCommand(options.command);
  const references = referenceRuns();
  const names = options.names.length > 0 ? options.names : [...references.keys()];
  const machineText = machine();
  const rows = sketchFiles(names).map((file) =>
    measure(file, references.get(sketchName(file)), options),
  );
  writeFileSync(options.out, documentOf(rows, { seed: options.seed, machineText }));
  console.log(`written: ${relative(process.cwd(), options.out)}`);
}

main().catch(exitWith);
