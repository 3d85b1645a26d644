// `npm run evaluate -- DIR_OR_FILES...`: solves sketches with the native command over several seeds,
// repeats every check with `liftarm check` on the written model, prints a table and writes CSV.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { basename, dirname, join, relative, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { build } from './build.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { beamsOverBound, csvField, median, summarise } from './lib/statistics.mjs';
import { setUp } from './setup.mjs';

const COMMAND = resolve(TOP, 'build/native/liftarm');
const USAGE = `npm run evaluate -- DIR_OR_FILES... [options]
  --seeds N      seeds 1 to N for each sketch (default 1)
  --set k=v      handed to \`liftarm solve\`; can be repeated
  --preset P     handed to \`liftarm solve\`
  --method M     handed to \`liftarm solve\`
  --jobs N       runs at the same time (default 1: more makes the times worse than they are)
  --timeout S    seconds after which a run is stopped and counts as hung (default 600)
  --csv FILE     default build/evaluate.csv
  --out DIR      models and parts lists, one folder a seed (default build/evaluate)
  --no-build     takes the command as it is
  --no-check     leaves out \`liftarm check\` on each written model`;

function readOptions() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      seeds: { type: 'string', default: '1' },
      set: { type: 'string', multiple: true, default: [] },
      preset: { type: 'string' },
      method: { type: 'string' },
      jobs: { type: 'string', default: '1' },
      timeout: { type: 'string', default: '600' },
      csv: { type: 'string', default: 'build/evaluate.csv' },
      out: { type: 'string', default: 'build/evaluate' },
      'no-build': { type: 'boolean', default: false },
      'no-check': { type: 'boolean', default: false },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help || positionals.length === 0) {
    throw new StepError(USAGE);
  }
  const whole = (key) => {
    const number = Number(values[key]);
    if (!Number.isInteger(number) || number < 1) {
      throw new StepError(`--${key} takes a whole number from 1 on, not '${values[key]}'`);
    }
    return number;
  };
  return {
    sketches: positionals.flatMap(sketchesOf),
    seeds: whole('seeds'),
    jobs: whole('jobs'),
    timeoutMs: whole('timeout') * 1000,
    passed: [
      ...values.set.flatMap((pair) => ['--set', pair]),
      ...(values.preset === undefined ? [] : ['--preset', values.preset]),
      ...(values.method === undefined ? [] : ['--method', values.method]),
    ],
    csv: resolve(values.csv),
    out: resolve(values.out),
    build: !values['no-build'],
    check: !values['no-check'],
  };
}

/** The sketch files that an argument names: itself, or those of a folder in natural order. */
function sketchesOf(path) {
  if (!existsSync(path)) {
    throw new StepError(`${path}: no such file or folder`);
  }
  if (!statSync(path).isDirectory()) {
    return [path];
  }
  const inOrder = new Intl.Collator('en', { numeric: true });
  return readdirSync(path)
    .filter((name) => name.endsWith('.sketch.json'))
    .sort(inOrder.compare)
    .map((name) => join(path, name));
}

/** Runs the command. `code` is null when it was stopped for taking too long. */
function command(args, timeoutMs) {
  return new Promise((done, fail) => {
    const start = performance.now();
    const child = spawn(COMMAND, args, { timeout: timeoutMs, killSignal: 'SIGKILL' });
    let stdout = '';
    let stderr = '';
    child.stdout.on('data', (data) => {
      stdout += data;
    });
    child.stderr.on('data', (data) => {
      stderr += data;
    });
    child.on('error', fail);
    child.on('close', (code, signal) =>
      done({ code, signal, stdout, stderr, seconds: (performance.now() - start) / 1000 }),
    );
  });
}

function parseReport(text) {
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}

/** Why a run does not count as a success, in one line; empty when it does. */
function failureOf({ code, signal, stderr }, report) {
  if (signal === 'SIGKILL') {
    return 'stopped: took too long';
  }
  if (code === 0) {
    if (report?.buildable !== true) {
      return 'exit 0 without a buildable report';
    }
    return report.beams < report.beamsLowerBound ? 'fewer beams than the bound says' : '';
  }
  if (code === 2) {
    const first = report?.problems?.[0];
    return (
      first?.message ?? (typeof first === 'string' ? first : 'not buildable, no problem named')
    );
  }
  return `${signal ?? `exit ${code}`}: ${stderr.trim().split('\n').at(-1) ?? ''}`;
}

/** The model file that `solve` has written: named after the sketch's own name or after its file. */
function modelFileIn(folder) {
  const name = existsSync(folder)
    ? readdirSync(folder).find((file) => file.endsWith('.model.json'))
    : undefined;
  return name === undefined ? null : join(folder, name);
}

async function runOnce(sketch, seed, options) {
  const folder = join(options.out, basename(sketch, '.sketch.json'), `seed-${seed}`);
  // A model of an earlier run must not be taken for one of this run.
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const result = await command(
    ['solve', sketch, '-o', folder, '--seed', `${seed}`, '--json', ...options.passed],
    options.timeoutMs,
  );
  const report = parseReport(result.stdout);
  let failure = failureOf(result, report);
  if (failure === '' && options.check) {
    failure = await repeatCheck(folder, report, options.timeoutMs);
  }
  return {
    ok: failure === '',
    report,
    wallSeconds: result.seconds,
    failure: failure && `seed ${seed}: ${failure}`,
  };
}

/** What search and check both count: each in its own way, so that they must agree. */
const COUNTED_TWICE = ['gaps', 'collisions', 'uncovered'];

async function repeatCheck(folder, report, timeoutMs) {
  const model = modelFileIn(folder);
  if (model === null) {
    return 'no model file was written';
  }
  const { code, signal, stdout } = await command(['check', model, '--json'], timeoutMs);
  if (code !== 0) {
    return `\`liftarm check\` ended with ${signal ?? code} on ${relative(TOP, model)}`;
  }
  const check = parseReport(stdout);
  const differs = COUNTED_TWICE.find((key) => check?.[key] !== report[key]);
  return differs === undefined
    ? ''
    : `${differs}: ${report[differs]} for the search, ${check?.[differs]} for the check of its model`;
}

/** Runs all tasks, at most `jobs` at the same time; results in the order of the tasks. */
async function runAll(tasks, jobs) {
  const results = new Array(tasks.length);
  let next = 0;
  const worker = async () => {
    while (next < tasks.length) {
      const i = next++;
      results[i] = await tasks[i]();
    }
  };
  await Promise.all(Array.from({ length: Math.min(jobs, tasks.length) }, worker));
  return results;
}

const COLUMNS = [
  ['sketch', 20, (row) => row.sketch],
  ['ok', 6, (row) => `${row.ok}/${row.runs}`],
  ['beams', 11, (row) => `${row.beamsMin ?? '-'} / ${row.beamsMedian ?? '-'}`],
  ['bound', 6, (row) => row.bound],
  ['bricks', 7, (row) => row.bricks],
  ['gaps', 5, (row) => row.gaps],
  ['coll.', 6, (row) => row.collisions],
  ['failed', 7, (row) => row.failed],
  ['loose', 6, (row) => row.loose],
  ['rigid', 6, (row) => `${row.rigid}/${row.runs}`],
  ['seconds', 8, (row) => row.seconds?.toFixed(2)],
  ['most', 7, (row) => row.secondsMax?.toFixed(2)],
];

function tableLine(cells) {
  return COLUMNS.map(([, width], i) => {
    const text = String(cells[i] ?? '-');
    return i === 0 ? text.padEnd(width) : text.padStart(width);
  }).join(' ');
}

function printSummary(rows) {
  const good = rows.filter((row) => row.ok === row.runs).length;
  const over = rows.map(beamsOverBound).filter((value) => value !== null);
  const mean = over.reduce((sum, value) => sum + value, 0) / over.length;
  const seconds = median(rows.map((row) => row.seconds));
  console.log(
    `\n${good} of ${rows.length} sketches buildable with every seed; beams over the bound: ` +
      `${over.length > 0 ? `${mean.toFixed(1)} %` : '-'} (mean); seconds: ${seconds?.toFixed(2) ?? '-'} (median)`,
  );
  const [longest] = rows
    .filter((row) => row.processorMax !== null && row.processorMax !== undefined)
    .sort((a, b) => b.processorMax - a.processorMax);
  if (longest) {
    console.log(
      `longest: ${longest.sketch}, ${longest.processorMax.toFixed(2)} s of one processor`,
    );
  }
  const stiff = rows.filter((row) => row.rigid >= 0.9 * row.runs).length;
  console.log(
    `${stiff} of ${rows.length} sketches without a freedom beyond their joints, all pins turning, ` +
      'with at least 9 of 10 seeds ("rigid"; "loose": most freedoms left)',
  );
  for (const row of rows.filter(({ failure }) => failure)) {
    console.log(`  ${row.sketch}: ${row.failure}`);
  }
}

function writeCsv(file, rows) {
  const keys = Object.keys(rows[0]);
  const lines = rows.map((row) => keys.map((key) => csvField(row[key])).join(','));
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, `${[keys.join(','), ...lines].join('\n')}\n`);
}

async function main() {
  const options = readOptions();
  if (options.sketches.length === 0) {
    throw new StepError('no *.sketch.json there');
  }
  if (options.build) {
    await setUp({ forTests: false });
    await build('command');
  }
  if (!existsSync(COMMAND)) {
    throw new StepError(`${relative(TOP, COMMAND)} is missing: run \`npm run build:native\` first`);
  }
  console.log(tableLine(COLUMNS.map(([title]) => title)));
  const rows = [];
  for (const sketch of options.sketches) {
    const seeds = Array.from({ length: options.seeds }, (_, i) => i + 1);
    const runs = await runAll(
      seeds.map((seed) => () => runOnce(sketch, seed, options)),
      options.jobs,
    );
    const row = summarise(basename(sketch, '.sketch.json'), runs);
    rows.push(row);
    console.log(tableLine(COLUMNS.map(([, , cell]) => cell(row))));
  }
  writeCsv(options.csv, rows);
  printSummary(rows);
  console.log(`written: ${relative(process.cwd(), options.csv)}`);
}

main().catch(exitWith);
