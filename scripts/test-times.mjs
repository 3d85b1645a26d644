// `npm run test:times`: where the time of the last `npm test` went: each step, the slowest tests of each runner and
// the slowest files of each build. Reads what the run left in build/; runs nothing.
import { existsSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { RUNNERS, resultsOf, STEPS_FILE, slowest, stepLines } from './lib/test-results.mjs';

const SHOWN = 15;
const BUILDS = ['native', 'wasm'];

/** What ninja last took for each file that it made. */
function compiled(build) {
  const log = resolve(TOP, 'build', build, '.ninja_log');
  if (!existsSync(log)) {
    return [];
  }
  const times = new Map();
  for (const line of readFileSync(log, 'utf8').split('\n').slice(1)) {
    const [start, end, , name] = line.split('\t');
    if (name !== undefined) {
      times.set(name, { name, seconds: (Number(end) - Number(start)) / 1000 });
    }
  }
  return [...times.values()];
}

function printSlowest(title, entries) {
  const total = entries.reduce((sum, { seconds }) => sum + seconds, 0);
  console.log(`\n${title}: ${entries.length}, ${total.toFixed(0)} s one after the other; slowest:`);
  for (const { name, seconds } of slowest(entries, SHOWN)) {
    console.log(`${seconds.toFixed(1).padStart(8)}  ${name}`);
  }
}

if (!existsSync(STEPS_FILE)) {
  exitWith(new StepError('There is no run to tell of: npm test'));
}
console.log(stepLines(JSON.parse(readFileSync(STEPS_FILE, 'utf8'))).join('\n'));
for (const { name } of RUNNERS) {
  const results = resultsOf(name);
  if (results !== null) {
    printSlowest(`Tests of ${name}`, results.tests);
  }
}
for (const build of BUILDS) {
  const files = compiled(build);
  if (files.length > 0) {
    printSlowest(`Files of the ${build} build`, files);
  }
}
