// `npm run ablate [-- SKETCH...]`: what each part of the search is worth. Solves sketches over several seeds with
// every part, then with one part at a time switched off, and writes docs/ablations.md.
import { writeFileSync } from 'node:fs';
import { relative, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { ABLATIONS, AIMS, summariseAblation } from './lib/ablations.mjs';
import { markdownTable, secondsText } from './lib/markdown.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { exitWith, StepError } from './lib/run.mjs';
import { machine, sketchFiles, sketchName, solve, wholeNumber } from './lib/solve.mjs';
import { median } from './lib/statistics.mjs';
import { withSymmetries } from './lib/symmetric-sketch.mjs';

const USAGE = `npm run ablate [-- SKETCH... options]
  SKETCH         a file or a name in ../shared/sketches; without any: some of all kinds
  --seeds N      seeds 1 to N for each sketch and part (default 4)
  --only PART    one part alone, by its key in scripts/lib/ablations.mjs; can be repeated
  --timeout S    seconds after which a run is stopped and counts as failed (default 60)
  --out FILE     default docs/ablations.md
  --command FILE the command to run (default build/native/liftarm, built first)`;

/** Small and large, flat and spatial, on and off the lattice: each hard for another part. */
const SKETCHES = [
  'airplane',
  'bicycle',
  'crossbow',
  'cube_3',
  'cube_5',
  'cube_9',
  'excavator',
  'fan',
  'flying_kite',
  'grid_4',
  'grid_8',
  'house',
  'lifter',
  'long_bow',
  'picker',
  'tower_2d',
];

function readOptions() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      seeds: { type: 'string', default: '4' },
      only: { type: 'string', multiple: true, default: [] },
      timeout: { type: 'string', default: '60' },
      out: { type: 'string', default: 'docs/ablations.md' },
      command: { type: 'string' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help) {
    throw new StepError(USAGE);
  }
  const keys = [...ABLATIONS, ...AIMS.flatMap(({ rows }) => rows)].map(({ key }) => key);
  const unknown = values.only.find((key) => !keys.includes(key));
  if (unknown !== undefined) {
    throw new StepError(`--only ${unknown}: no such part; known are ${keys.join(', ')}`);
  }
  const wanted = ({ key }) => values.only.length === 0 || values.only.includes(key);
  return {
    names: positionals.length > 0 ? positionals : SKETCHES,
    seeds: wholeNumber('seeds', values.seeds),
    // The whole search is always measured: all others are compared with it.
    rows: ABLATIONS.filter((row, i) => i === 0 || wanted(row)),
    aims: AIMS.map((aim) => ({ ...aim, rows: aim.rows.filter(wanted) })).filter(
      ({ rows }) => rows.length > 0,
    ),
    timeoutMs: wholeNumber('timeout', values.timeout) * 1000,
    out: resolve(values.out),
    command: values.command,
  };
}

function runsOf(row, files, { command, seeds, timeoutMs, args = [] }) {
  return files.flatMap((file) =>
    Array.from({ length: seeds }, (_, i) => ({
      sketch: sketchName(file),
      report: solve(command, {
        sketch: file,
        args: ['--seed', `${i + 1}`, ...args, ...row.set.flatMap((pair) => ['--set', pair])],
        timeoutMs,
      }),
    })),
  );
}

const TITLES = [
  'switched off',
  'buildable',
  'beams over bound',
  'bricks',
  'seconds',
  'slowest',
  'unreliable',
];

function cellsOf({ row, result, whole }) {
  const bricks =
    result.bricks === null || whole.bricks === null ? null : result.bricks / whole.bricks;
  return [
    row.title,
    `${result.buildable} of ${result.runs}`,
    result.overBound === null ? '-' : `${result.overBound.toFixed(1)} %`,
    bricks === null ? '-' : `${(100 * (bricks - 1)).toFixed(1)} %`,
    secondsText(result.seconds),
    secondsText(result.slowest),
    result.unreliable.join(', ') || '-',
  ];
}

/** The rows of one aim: with all parts, then with each of its own switched off. */
function aimCells(aim, options) {
  const files = sketchFiles(aim.sketches).map((file) =>
    aim.symmetric ? withSymmetries(options.command, file).file : file,
  );
  return [ABLATIONS[0], ...aim.rows].map((row) => {
    const runs = runsOf(row, files, { ...options, args: aim.args });
    const reports = runs.map(({ report }) => report).filter((report) => report !== null);
    const cells = [
      row.title,
      `${reports.filter(aim.isGood).length} of ${runs.length}`,
      `${reports.filter(({ buildable }) => buildable).length} of ${runs.length}`,
      `${median(reports.map(({ beams }) => beams))}`,
      secondsText(median(reports.map(({ seconds }) => seconds.processor))),
    ];
    console.log(cells.join('  '));
    return cells;
  });
}

const aimText = ({ title, about, sketches, good, rows }, cells) => `
## ${title}

Of ${sketches.join(', ')}: ${about}. Beams and seconds of the processor: medians.

${markdownTable(['switched off', good, 'buildable', 'beams', 'seconds'], cells)}

${rows.map((row) => `- **${row.title}** (\`${row.set.join(' ')}\`): ${row.about}`).join('\n')}
`;

function documentOf(rows, aims, { names, seeds, machineText }) {
  return `# What each part of the search is worth

Made by \`npm run ablate\`; do not edit. ${machineText}; one thread; seeds 1 to ${seeds} of: ${names.join(', ')}.

Each row switches one part off (\`liftarm solve --set\`) and leaves all others on. Beams over the bound: mean over
the buildable runs. Bricks: geometric mean against the whole search, over the runs that both could build. Seconds
of the processor: median over all runs, also those that failed, and the slowest of them. Unreliable: sketches that
not every seed could build.

${markdownTable(TITLES, rows.map(cellsOf))}

${rows.map(({ row }) => `- **${row.title}** (\`${row.set.join(' ') || 'default'}\`): ${row.about}`).join('\n')}
${aims.join('')}`;
}

async function main() {
  const options = readOptions();
  options.command = await readyCommand(options.command);
  const files = sketchFiles(options.names);
  const machineText = machine();
  const rows = [];
  let wholeRuns = null;
  for (const row of options.rows) {
    const runs = runsOf(row, files, options);
    wholeRuns ??= runs;
    const result = summariseAblation(runs, wholeRuns);
    const whole = summariseAblation(wholeRuns, runs);
    rows.push({ row, result, whole });
    console.log(cellsOf(rows.at(-1)).join('  '));
  }
  const aims = options.aims.map((aim) => aimText(aim, aimCells(aim, options)));
  const names = files.map(sketchName);
  writeFileSync(options.out, documentOf(rows, aims, { ...options, names, machineText }));
  console.log(`written: ${relative(process.cwd(), options.out)}`);
}

main().catch(exitWith);
