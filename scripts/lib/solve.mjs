// Runs `liftarm solve` for the scripts that measure. Node alone, no packages.
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { availableParallelism, cpus, loadavg } from 'node:os';
import { basename, resolve } from 'node:path';
import { StepError, TOP } from './run.mjs';

const SHARED = resolve(TOP, '../shared');
const ENDING = '.sketch.json';

/** The sketches that arguments name: a file, or a name in ../shared/sketches; all of them for none. */
export function sketchFiles(names) {
  const folder = resolve(SHARED, 'sketches');
  if (names.length === 0 && existsSync(folder)) {
    const inOrder = new Intl.Collator('en', { numeric: true });
    return readdirSync(folder)
      .filter((name) => name.endsWith(ENDING))
      .sort(inOrder.compare)
      .map((name) => resolve(folder, name));
  }
  return names.map((name) => {
    const found = [resolve(name), resolve(folder, `${name}${ENDING}`)].find(existsSync);
    if (found === undefined) {
      throw new StepError(`${name}: no such sketch file, and none in ../shared/sketches`);
    }
    return found;
  });
}

export function sketchName(file) {
  return basename(file, ENDING);
}

/** The runs of the authors' own program, the first of each sketch. */
export function referenceRuns() {
  const file = resolve(SHARED, 'reference-runs.json');
  if (!existsSync(file)) {
    throw new StepError(
      '../shared/reference-runs.json is missing: it has the figures to compare with',
    );
  }
  const runs = new Map();
  for (const run of JSON.parse(readFileSync(file, 'utf8')).runs) {
    if (!runs.has(run.sketch)) {
      runs.set(run.sketch, run);
    }
  }
  return runs;
}

/**
 * One run without files.
 * @param {string} command path of the native command
 * @returns {Record<string, any> | null} the report; null when it took too long.
 * @throws {StepError} when the sketch is refused or the command breaks.
 */
export function solve(command, { sketch, args, timeoutMs }) {
  const result = spawnSync(command, ['solve', sketch, '--no-files', '--json', ...args], {
    encoding: 'utf8',
    maxBuffer: 64 << 20,
    timeout: timeoutMs,
    killSignal: 'SIGKILL',
  });
  if (result.signal === 'SIGKILL') {
    return null;
  }
  if (result.status !== 0 && result.status !== 2) {
    throw new StepError(`liftarm solve ${sketch}: ${result.stderr || result.error?.message}`);
  }
  return JSON.parse(result.stdout);
}

/** A whole number from 1 on, or a message that names the option. */
export function wholeNumber(option, text) {
  const number = Number(text);
  if (!Number.isInteger(number) || number < 1) {
    throw new StepError(`--${option} takes a whole number from 1 on, not '${text}'`);
  }
  return number;
}

/** The machine in one line, for the head of a table of seconds. */
export function machine() {
  return (
    `${cpus()[0]?.model ?? 'unknown processor'}, ${availableParallelism()} cores, ` +
    `load ${loadavg()[0].toFixed(1)} at the start`
  );
}
