// `npm run bench:scaling [-- --seeds N]`: how the seconds of search grow with the length of a sketch. Solves
// the cubes and the repeated kites of ../shared/sketches with the native command, one after the other, and
// fits seconds = factor * length ^ exponent to each family.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import { availableParallelism, cpus, loadavg } from 'node:os';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { fitPower } from './lib/power-fit.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { median } from './lib/statistics.mjs';

const COMMAND = resolve(TOP, 'build/native/liftarm');
const SKETCHES = resolve(TOP, '../shared/sketches');
const OUT = resolve(TOP, 'build/bench');
const FAMILIES = {
  cubes: [3, 5, 7, 9, 11, 13, 15, 17, 19, 21].map((side) => `cube_${side}`),
  kites: ['flying_kite', 'flying_kite_x2', 'flying_kite_x3', 'flying_kite_x4'],
};

/** @returns the report of one run; one that is solved but not buildable counts all the same. */
function solve(name, seed) {
  const sketch = resolve(SKETCHES, `${name}.sketch.json`);
  const args = ['solve', sketch, '-o', OUT, '--seed', `${seed}`, '--json'];
  const result = spawnSync(COMMAND, args, { encoding: 'utf8', maxBuffer: 64 << 20 });
  if (result.status !== 0 && result.status !== 2) {
    throw new StepError(`liftarm solve ${name}: ${result.stderr || result.error?.message}`);
  }
  return JSON.parse(result.stdout);
}

function measure(name, seeds) {
  const reports = seeds.map((seed) => solve(name, seed));
  const seconds = median(reports.map((report) => report.seconds.total));
  const buildable = reports.filter((report) => report.buildable).length;
  const { length, iterations } = reports[0];
  console.log(
    `${name.padEnd(16)} ${String(length).padStart(6)} ${seconds.toFixed(3).padStart(9)} ` +
      `${String(iterations).padStart(10)}   ${buildable}/${seeds.length}`,
  );
  return { x: length, y: seconds };
}

function main() {
  const { values } = parseArgs({ options: { seeds: { type: 'string', default: '3' } } });
  const count = Number(values.seeds);
  if (!Number.isInteger(count) || count < 1) {
    throw new StepError(`--seeds ${values.seeds}: a whole number from 1 on is needed`);
  }
  if (!existsSync(COMMAND)) {
    throw new StepError('build/native/liftarm is missing: npm run build:native');
  }
  if (!existsSync(SKETCHES)) {
    throw new StepError('../shared/sketches is missing: this benchmark needs its cubes and kites');
  }
  mkdirSync(OUT, { recursive: true });
  const seeds = Array.from({ length: count }, (_, i) => i + 1);
  console.log(
    `${cpus()[0]?.model ?? 'unknown processor'}, ${availableParallelism()} cores, ` +
      `load ${loadavg()[0].toFixed(1)}; medians over ${count} seeds`,
  );
  console.log('sketch           length   seconds iterations   buildable');
  for (const [family, names] of Object.entries(FAMILIES)) {
    const fit = fitPower(names.map((name) => measure(name, seeds)));
    if (fit !== null) {
      console.log(
        `${family}: seconds grow with length ^ ${fit.exponent.toFixed(2)} ` +
          `(R squared ${fit.rSquared.toFixed(2)})\n`,
      );
    }
  }
}

try {
  main();
} catch (error) {
  exitWith(error);
}
