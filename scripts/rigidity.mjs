// `npm run rigidity -- [SKETCHES] [options]`: how many seeds of the rigid preset end with no internal freedom, for
// sketches that stand by themselves: cubes, small grids, house, tables, chair, shelf. Judges the models, all pins
// turning; says what is over the bound of beams and which freedoms are left.
import { existsSync, readdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { sketchFiles, sketchName, solve, wholeNumber } from './lib/solve.mjs';
import { median } from './lib/statistics.mjs';

const COMMAND = resolve(TOP, 'build/native/liftarm');
const TABLES = resolve(TOP, 'tests/data/tables');
const EXAMPLES = ['table', 'chair', 'box-shelf', 'house', 'cube'];
const SHARED = /^(cube_\d+|grid_[3-8]|house)$/;
const USAGE = `npm run rigidity -- [SKETCHES] [options]
  --seeds N     seeds 1 to N for each sketch (default 10)
  --least N     seeds that must end stiff, else the exit code is 1 (default 9 of 10)
  --preset P    default simple-rigid
  --set k=v     handed to \`liftarm solve\`; can be repeated`;

/** Cubes, grids of 3 to 8 meshes, house and tables. */
function usualSketches() {
  const tables = readdirSync(TABLES).filter((name) => name.endsWith('.sketch.json'));
  return [
    ...sketchFiles([]).filter((file) => SHARED.test(sketchName(file))),
    ...tables.map((name) => resolve(TABLES, name)),
    ...EXAMPLES.map((name) => resolve(TOP, `public/examples/${name}.sketch.json`)).filter(
      existsSync,
    ),
  ];
}

const counted = (values) =>
  [...new Set(values)]
    .sort((a, b) => a - b)
    .map((value) => `${values.filter((other) => other === value).length}x ${value}`)
    .join(', ');

function main() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      seeds: { type: 'string', default: '10' },
      least: { type: 'string' },
      preset: { type: 'string', default: 'simple-rigid' },
      set: { type: 'string', multiple: true, default: [] },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help) {
    throw new StepError(USAGE);
  }
  const seeds = wholeNumber('seeds', values.seeds);
  const least = values.least ? wholeNumber('least', values.least) : Math.ceil(0.9 * seeds);
  const passed = values.set.flatMap((pair) => ['--set', pair]);
  console.log(
    'sketch               stiff  buildable  beams  bound  bricks  processor  freedoms left',
  );
  for (const sketch of positionals.length > 0 ? sketchFiles(positionals) : usualSketches()) {
    const runs = Array.from({ length: seeds }, (_, i) =>
      solve(COMMAND, {
        sketch,
        args: ['--preset', values.preset, '--seed', String(i + 1), ...passed],
        timeoutMs: 600_000,
      }),
    ).filter((report) => report !== null);
    const stiff = runs.filter(({ freedoms }) => freedoms === 0).length;
    const left = runs.map(({ freedoms }) => freedoms).filter((freedoms) => freedoms !== 0);
    console.log(
      [
        sketchName(sketch).padEnd(20),
        `${stiff}/${seeds}`.padStart(5),
        `${runs.filter(({ buildable }) => buildable).length}/${seeds}`.padStart(10),
        String(median(runs.map(({ beams }) => beams))).padStart(6),
        String(runs[0]?.beamsLowerBound ?? '-').padStart(6),
        String(median(runs.map(({ bricks }) => bricks))).padStart(7),
        median(runs.map(({ seconds }) => seconds.processor))
          .toFixed(1)
          .padStart(10),
        `  ${counted(left)}`,
      ].join(' '),
    );
    if (stiff < least) {
      process.exitCode = 1;
    }
  }
}

try {
  main();
} catch (error) {
  exitWith(error);
}
