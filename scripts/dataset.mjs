// `npm run dataset [-- --count N --solve]`: writes the first N sketches of the data set, and solves them.
import { spawnSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { relative, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { dataset } from './lib/families/families.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { wholeNumber } from './lib/solve.mjs';
import { csvField } from './lib/statistics.mjs';

const USAGE = `npm run dataset [-- options]
  --count N      how many sketches (default 1000)
  --out DIR      default build/dataset: NAME.sketch.json
  --solve        solves each, writes NAME.model.json beside it, and RESULTS
  --results FILE default docs/dataset/results.csv, one line a sketch
  --set k=v      handed to \`liftarm solve\`; can be repeated
  --command FILE the command to run (default build/native/liftarm, built first)`;

/** As docs/dataset/README.md says: the same on every machine. */
const COLUMNS = [
  'name',
  'family',
  'size',
  'lines',
  'length',
  'buildable',
  'beams',
  'axles',
  'bricks',
  'gaps',
  'collisions',
  'failedConnections',
  'uncovered',
  'freedomsBeyondJoints',
  'beamsLowerBound',
];

function readOptions() {
  const { values } = parseArgs({
    options: {
      count: { type: 'string', default: '1000' },
      out: { type: 'string', default: 'build/dataset' },
      solve: { type: 'boolean', default: false },
      results: { type: 'string', default: 'docs/dataset/results.csv' },
      set: { type: 'string', multiple: true, default: [] },
      command: { type: 'string' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help) {
    throw new StepError(USAGE);
  }
  return { ...values, count: wholeNumber('count', values.count), out: resolve(TOP, values.out) };
}

function solved(command, file, { out, set }) {
  const pairs = set.flatMap((pair) => ['--set', pair]);
  const args = ['solve', file, '-o', out, '--json', '--seed', '1', ...pairs];
  const result = spawnSync(command, args, { encoding: 'utf8', maxBuffer: 1 << 28 });
  if (result.status !== 0 && result.status !== 2) {
    throw new StepError(`${file}: ${result.stderr}`);
  }
  return JSON.parse(result.stdout);
}

async function main() {
  const options = readOptions();
  const command = options.solve ? await readyCommand(options.command) : null;
  mkdirSync(options.out, { recursive: true });
  const rows = [];
  for (const { name, family, size, sketch } of dataset(options.count)) {
    const file = resolve(options.out, `${name}.sketch.json`);
    writeFileSync(file, `${JSON.stringify(sketch)}\n`);
    if (command !== null) {
      const report = { ...solved(command, file, options), name, family, size };
      rows.push(COLUMNS.map((column) => csvField(report[column])).join(','));
    }
  }
  console.log(`${options.count} sketches in ${relative(process.cwd(), options.out)}`);
  if (command !== null) {
    const results = resolve(TOP, options.results);
    mkdirSync(resolve(results, '..'), { recursive: true });
    writeFileSync(results, `${COLUMNS.join(',')}\n${rows.join('\n')}\n`);
    const buildable = rows.filter((row) => row.split(',')[5] === 'true').length;
    console.log(`${buildable} of ${rows.length} buildable: ${relative(process.cwd(), results)}`);
  }
}

main().catch(exitWith);
