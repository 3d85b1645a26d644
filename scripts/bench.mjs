// `npm run bench -- SKETCHES... [--seeds N]`: seconds of search by the native command and by the shipped
// WebAssembly module in Node, one thread each, one after the other. Both must give the same model.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism, cpus, loadavg } from 'node:os';
import { basename, join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { median } from './lib/statistics.mjs';

const COMMAND = resolve(TOP, 'build/native/liftarm');
const WASM = resolve(TOP, 'build/wasm');
/** Iterations of one call, about what the page's worker takes. */
const SLICE = 500;

async function loadModule() {
  const { default: create } = await import(join(WASM, 'liftarm-core.js'));
  return create({ wasmBinary: readFileSync(join(WASM, 'liftarm-core.wasm')) });
}

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

async function main() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { seeds: { type: 'string', default: '3' } },
  });
  if (positionals.length === 0) {
    throw new StepError('npm run bench -- SKETCHES... [--seeds N]');
  }
  const seeds = Array.from({ length: Number(values.seeds) }, (_, i) => i + 1);
  console.log(
    `${cpus()[0]?.model ?? 'unknown processor'}, ${availableParallelism()} cores, ` +
      `load ${loadavg()[0].toFixed(1)}, Node ${process.version}; medians over ${seeds.length} seeds`,
  );
  console.log('sketch                 native s    wasm s   factor   same model');
  const module = await loadModule();
  for (const sketch of positionals) {
    const runs = seeds.map((seed) => [solveNative(sketch, seed), solveWasm(module, sketch, seed)]);
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
}

main().catch(exitWith);
