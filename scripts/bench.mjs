// `npm run bench -- SKETCHES... [--seeds N]`: seconds of search by the native command and by the shipped
// WebAssembly module in Node, one thread each, one after the other. Both must give the same model.
// `--browser` runs the module in Chromium. `--checks` measures the checks of the models instead: milliseconds of each in WebAssembly, the
// first time and later, and of `liftarm check`, start and reading included; with `--browser` in Chromium too.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism, cpus, loadavg } from 'node:os';
import { basename, join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { CHECKS, timeChecks } from './lib/bench-checks.mjs';
import { openBrowserSolver, timeChecksInBrowser } from './lib/browser-solver.mjs';
import { loadCore } from './lib/load-core.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { median } from './lib/statistics.mjs';

const COMMAND = resolve(TOP, 'build/native/liftarm');
/** Iterations of one call, about what the page's worker takes. */
const SLICE = 500;

/** @returns seconds of search and the model's text. */
function solveNative(sketch, seed) {
  const out = resolve(TOP, 'build/bench');
  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  let stdout;
  try {
    const args = ['solve', sketch, '-o', out, '--seed', `${seed}`, '--json'];
    stdout = execFileSync(COMMAND, args, { encoding: 'utf8', stdio: 'pipe' });
  } catch (error) {
    // 2 means solved but not buildable: its time counts all the same.
    if (error.status !== 2) {
      throw new StepError(`liftarm solve ${sketch}: ${error.stderr ?? error.message}`);
    }
    stdout = error.stdout;
  }
  const model = readdirSync(out).find((name) => name.endsWith('.model.json'));
  return {
    seconds: JSON.parse(stdout).seconds.total,
    file: join(out, model),
    model: readFileSync(join(out, model), 'utf8').trimEnd(),
  };
}

function solveWasm(module, sketch, seed) {
  const text = readFileSync(sketch, 'utf8');
  const start = performance.now();
  const session = new module.SolverSession(text, JSON.stringify({ seed }));
  const { status, text: message } = session.opened();
  if (status !== 'ok') {
    throw new StepError(`${sketch}: ${message}`);
  }
  while (!session.advance(SLICE)) {
    // The search goes on.
  }
  const seconds = (performance.now() - start) / 1000;
  const model = session.modelJson().trimEnd();
  session.delete();
  return { seconds, model };
}

/** @returns milliseconds of all checks of a model file by the native command. */
function checkNative(file) {
  const start = performance.now();
  try {
    execFileSync(COMMAND, ['check', file], { stdio: 'pipe' });
  } catch (error) {
    // 2 means not buildable: its time counts all the same.
    if (error.status !== 2) {
      throw new StepError(`liftarm check ${file}: ${error.stderr ?? error.message}`);
    }
  }
  return performance.now() - start;
}

const cells = (...numbers) =>
  numbers.map((number) => (number === null ? '-' : number.toFixed(0)).padStart(12)).join('');

async function benchChecks(sketches, repeats, inBrowser) {
  console.log(`milliseconds; later: medians over ${repeats} calls after the first`);
  console.log('own: of the thread that answers; all: with the compiler beside it');
  console.log(
    `${''.padEnd(24)}   first own   first all   later own  later wall native wall${
      inBrowser ? ' Chrome first Chrome later' : ''
    }`,
  );
  for (const sketch of sketches) {
    const { file, model } = solveNative(sketch, 1);
    console.log(`${basename(sketch, '.sketch.json')}, ${JSON.parse(model).parts.length} parts`);
    const native = median(Array.from({ length: repeats }, () => checkNative(file)));
    // Node keeps what it compiled: in it only the first model of a run has a true first call.
    const rows = timeChecks(await loadCore(), model, repeats);
    const there = inBrowser ? await timeChecksInBrowser(CHECKS, model, repeats) : [];
    const row = (title, { first, later }, beside, browser) =>
      console.log(
        `  ${title.padEnd(22)}${cells(first.own, first.all, later.own, later.wall, beside)}${
          browser ? cells(browser.first, browser.later) : ''
        }`,
      );
    for (const [i, times] of rows.entries()) {
      row(times.check, times, times.check === 'buildable' ? native : null, there[i]);
    }
    const sum = (of) => rows.reduce((total, times) => total + of(times), 0);
    const total = (call) => ({
      own: sum((times) => times[call].own),
      all: sum((times) => times[call].all),
      wall: sum((times) => times[call].wall),
    });
    const inAll = (call) => there.reduce((all, times) => all + times[call], 0);
    row(
      'all',
      { first: total('first'), later: total('later') },
      null,
      inBrowser && { first: inAll('first'), later: inAll('later') },
    );
  }
}

/** The module in Node or in Chromium. */
async function openSolver(inBrowser) {
  if (!inBrowser) {
    const module = await loadCore();
    return { solve: (sketch, seed) => solveWasm(module, sketch, seed), close: () => {} };
  }
  const browser = await openBrowserSolver(SLICE);
  return {
    solve: async (sketch, seed) => {
      const { seconds, model } = await browser.solve(readFileSync(sketch, 'utf8'), { seed });
      return { seconds, model: model.trimEnd() };
    },
    close: browser.close,
  };
}

async function main() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      seeds: { type: 'string', default: '3' },
      checks: { type: 'boolean', default: false },
      browser: { type: 'boolean', default: false },
    },
  });
  if (positionals.length === 0) {
    throw new StepError('npm run bench -- SKETCHES... [--seeds N] [--browser] [--checks]');
  }
  if (values.checks) {
    return benchChecks(positionals, 7, values.browser);
  }
  const seeds = Array.from({ length: Number(values.seeds) }, (_, i) => i + 1);
  console.log(
    `${cpus()[0]?.model ?? 'unknown processor'}, ${availableParallelism()} cores, ` +
      `load ${loadavg()[0].toFixed(1)}, Node ${process.version}; medians over ${seeds.length} seeds`,
  );
  console.log('sketch                 native s    wasm s   factor   same model');
  const solver = await openSolver(values.browser);
  for (const sketch of positionals) {
    const runs = [];
    for (const seed of seeds) {
      runs.push([solveNative(sketch, seed), await solver.solve(sketch, seed)]);
    }
    const native = median(runs.map(([run]) => run.seconds));
    const wasm = median(runs.map(([, run]) => run.seconds));
    const same = runs.every(([a, b]) => a.model === b.model);
    console.log(
      `${basename(sketch, '.sketch.json').padEnd(20)} ${native.toFixed(2).padStart(10)} ` +
        `${wasm.toFixed(2).padStart(9)} ${(wasm / native).toFixed(2).padStart(8)}   ${same ? 'yes' : 'NO'}`,
    );
    if (!same) {
      process.exitCode = 1;
    }
  }
  await solver.close();
}

main().catch(exitWith);
