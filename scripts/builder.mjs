// `npm run builder -- DIR_OR_FILES...`: how well built models are (DESIGN 5b): one row a model, and the totals that a
// builder would look at. Takes sketches, which it solves, and model files, which it checks.
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import { parseArgs } from 'node:util';
import { figuresOf, totals, verdicts } from './lib/builder-figures.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { exitWith, StepError } from './lib/run.mjs';
import { sketchFiles, solve, wholeNumber } from './lib/solve.mjs';

const SKETCH = '.sketch.json';
const MODEL = '.model.json';
const USAGE = `npm run builder -- DIR_OR_FILES... [options]
  Sketches (files, folders, or names in ../shared/sketches; none: all of those) are solved, models
  (*.model.json) are checked.
  --preset P     handed to \`liftarm solve\`
  --set k=v      handed to \`liftarm solve\`; can be repeated
  --seeds N      seeds 1 to N for each sketch (default 1)
  --timeout S    seconds after which a run is given up (default 600)
  --command FILE the native command to run (default: ours, built first)
  --no-build     takes our command as it is
  --json         prints one JSON object instead of the table`;

function readOptions() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      preset: { type: 'string' },
      set: { type: 'string', multiple: true, default: [] },
      seeds: { type: 'string', default: '1' },
      timeout: { type: 'string', default: '600' },
      command: { type: 'string' },
      'no-build': { type: 'boolean', default: false },
      json: { type: 'boolean', default: false },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help) {
    throw new StepError(USAGE);
  }
  return {
    files: positionals.length > 0 ? positionals.flatMap(filesOf) : sketchFiles([]),
    seeds: wholeNumber('seeds', values.seeds),
    timeoutMs: wholeNumber('timeout', values.timeout) * 1000,
    passed: [
      ...values.set.flatMap((pair) => ['--set', pair]),
      ...(values.preset === undefined ? [] : ['--preset', values.preset]),
    ],
    command: values.command ?? (values['no-build'] ? 'build/native/liftarm' : undefined),
    json: values.json,
  };
}

/** The sketches and models that an argument names: itself, a name, or those of a folder in natural order. */
function filesOf(path) {
  if (!existsSync(path) || !statSync(path).isDirectory()) {
    return path.endsWith(MODEL) && existsSync(path) ? [path] : sketchFiles([path]);
  }
  const inOrder = new Intl.Collator('en', { numeric: true });
  return readdirSync(path)
    .filter((name) => name.endsWith(SKETCH) || name.endsWith(MODEL))
    .sort(inOrder.compare)
    .map((name) => join(path, name));
}

function check(command, file) {
  const result = spawnSync(command, ['check', file, '--json'], {
    encoding: 'utf8',
    maxBuffer: 64 << 20,
  });
  if (result.status !== 0 && result.status !== 2) {
    throw new StepError(`liftarm check ${file}: ${result.stderr || result.error?.message}`);
  }
  return JSON.parse(result.stdout);
}

/** One run of one file; null when it took too long. */
function runOnce(command, file, seed, options) {
  const isModel = file.endsWith(MODEL);
  const report = isModel
    ? check(command, file)
    : solve(command, {
        sketch: file,
        args: ['--seed', String(seed), ...options.passed],
        timeoutMs: options.timeoutMs,
      });
  return report === null
    ? null
    : {
        name: basename(file, isModel ? MODEL : SKETCH),
        seed: isModel ? null : seed,
        buildable: report.buildable,
        beams: report.beams,
        bound: report.beamsLowerBound ?? null,
        seconds: report.seconds?.total ?? null,
        figures: figuresOf(report.wellBuilt),
      };
}

const number = (value, digits = 0) => (Number.isFinite(value) ? value.toFixed(digits) : '-');
const percent = (part, whole) => (whole > 0 ? number((100 * part) / whole, 1) : '-');

const COLUMNS = [
  ['model', 22, (run) => (run.seed > 1 ? `${run.name} #${run.seed}` : run.name)],
  ['ok', 3, (run) => (run.buildable ? 'yes' : 'NO')],
  ['built', 5, ({ figures: f }) => `${f.passed}/${f.of}`],
  ['naked%', 7, ({ figures: f }) => percent(f.nakedHeads, f.heads)],
  ['arms', 5, ({ figures: f }) => number(f.idleArms)],
  ['1axis', 6, ({ figures: f }) => number(f.beamsOnOneAxis)],
  ['below', 6, ({ figures: f }) => number(f.belowBase)],
  ['lifted', 7, ({ figures: f }) => number(f.liftedFeet)],
  ['falls', 6, ({ figures: f }) => (f.couldStand ? (f.fallsOver ? 'YES' : 'no') : '-')],
  ['loose', 6, ({ figures: f }) => number(f.freedomsBeyondJoints)],
  ['layer', 6, ({ figures: f }) => number(f.meanLayer, 2)],
  ['out', 5, ({ figures: f }) => number(f.greatestProtrusion, 1)],
  [
    'mirror%',
    8,
    ({ figures: f }) => percent(f.mirroredBeams, f.items.symmetric.applies ? f.beams : 0),
  ],
  ['kinds', 6, ({ figures: f }) => number(f.kinds)],
  ['bricks', 7, ({ figures: f }) => number(f.parts)],
  ['beams', 6, ({ beams }) => number(beams)],
  ['bound', 6, ({ bound }) => number(bound)],
  ['seconds', 8, ({ seconds }) => number(seconds, 2)],
];

function tableLine(cells) {
  return COLUMNS.map(([, width], i) =>
    i === 0 ? String(cells[i]).padEnd(width) : String(cells[i]).padStart(width),
  ).join(' ');
}

function printTotals(all) {
  console.log(
    `\n${all.models} models, ${number(all.passed, 1)} of 6 on average; ${all.beams} beams, ${all.bricks} parts, ` +
      `${number(all.kinds, 1)} kinds a model; ${number(all.seconds, 1)} s in all, ` +
      `${number(all.secondsMost, 1)} s at most`,
  );
  console.log(
    `${all.flatBases} drawings with a flat base, ${all.couldStand} that could stand, ` +
      `${all.symmetricDrawings} symmetric; pin heads alone: ${number(all.nakedPinHeads, 1)} % naked; ` +
      `connector arms that hold nothing: ${number(all.idleArms, 1)} %`,
  );
  for (const { title, value, asked, ok } of verdicts(all)) {
    console.log(
      `  ${ok ? 'yes' : 'NO '}  ${title.padEnd(38)} ${number(value, 2).padStart(7)}   ${asked}`,
    );
  }
}

async function main() {
  const options = readOptions();
  if (options.files.length === 0) {
    throw new StepError('no *.sketch.json or *.model.json there');
  }
  const command = await readyCommand(options.command);
  const say = (line) => options.json || console.log(line);
  say(tableLine(COLUMNS.map(([title]) => title)));
  const runs = [];
  const late = [];
  for (const file of options.files) {
    const seeds = file.endsWith(MODEL) ? 1 : options.seeds;
    for (let seed = 1; seed <= seeds; ++seed) {
      const run = runOnce(command, file, seed, options);
      if (run === null) {
        late.push(`${file} seed ${seed}`);
        continue;
      }
      runs.push(run);
      say(tableLine(COLUMNS.map(([, , cell]) => cell(run))));
    }
  }
  const all = totals(runs);
  if (options.json) {
    console.log(JSON.stringify({ runs, totals: all, verdicts: verdicts(all), late }));
  } else {
    printTotals(all);
    for (const name of late) {
      console.log(`  given up: ${name}`);
    }
  }
}

main().catch(exitWith);
