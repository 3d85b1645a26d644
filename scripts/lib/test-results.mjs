// What the runners of `npm test` wrote down: how many tests passed, and how long each of them took.
import { existsSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { TOP } from './run.mjs';

export const RESULTS = resolve(TOP, 'build/test-results');
export const STEPS_FILE = resolve(RESULTS, 'steps.json');

/**
 * @typedef {{ name: string, seconds: number }} Timed
 * @typedef {{ passed: number, failed: number, skipped: number, second?: string[], tests: Timed[] }} Results
 */

const inQuotes = (text, name) => text.match(new RegExp(`\\b${name}="([^"]*)"`))?.[1];

/** @returns {Results} */
export function readCtest(text) {
  const head = text.slice(0, 4000);
  const count = (name) => Number(inQuotes(head, name) ?? 0);
  const skipped = count('skipped') + count('disabled');
  return {
    passed: count('tests') - count('failures') - skipped,
    failed: count('failures'),
    skipped,
    tests: [...text.matchAll(/<testcase ([^>]*)>/g)].map(([, attributes]) => ({
      name: inQuotes(attributes, 'name'),
      seconds: Number(inQuotes(attributes, 'time')),
    })),
  };
}

/** @returns {Results} */
export function readVitest(text) {
  const { numPassedTests, numFailedTests, numPendingTests, numFailedTestSuites, success, ...more } =
    JSON.parse(text);
  // A file that does not even load has no failed test of its own.
  const failed = success ? 0 : Math.max(numFailedTests, Math.min(1, numFailedTestSuites));
  const tests = more.testResults.flatMap(({ name: file, assertionResults }) =>
    assertionResults.map(({ fullName, duration }) => ({
      name: `${file.replace(`${TOP}/`, '')}: ${fullName}`,
      seconds: (duration ?? 0) / 1000,
    })),
  );
  return { passed: numPassedTests, failed, skipped: numPendingTests, tests };
}

/** @returns {Results} */
export function readPlaywright(text) {
  const { stats, suites } = JSON.parse(text);
  const inside = (suite) => [...(suite.specs ?? []), ...(suite.suites ?? []).flatMap(inside)];
  const specs = suites.flatMap(inside).map(({ file, title, tests }) => ({
    name: `${file}: ${title}`,
    flaky: tests.some(({ status }) => status === 'flaky'),
    seconds:
      tests.flatMap(({ results }) => results).reduce((sum, { duration }) => sum + duration, 0) /
      1000,
  }));
  return {
    passed: stats.expected + stats.flaky,
    failed: stats.unexpected,
    skipped: stats.skipped,
    second: specs.filter(({ flaky }) => flaky).map(({ name }) => name),
    tests: specs.map(({ name, seconds }) => ({ name, seconds })),
  };
}

/** The runners, in the order in which they run. */
export const RUNNERS = [
  { name: 'native', file: resolve(RESULTS, 'ctest.xml'), read: readCtest },
  { name: 'vitest', file: resolve(RESULTS, 'vitest.json'), read: readVitest },
  { name: 'browser', file: resolve(RESULTS, 'playwright.json'), read: readPlaywright },
];

const runnerOf = (name) => RUNNERS.find((runner) => runner.name === name);

/** Where a runner writes its results. */
export const fileOf = (name) => runnerOf(name).file;

/** @returns {Results | null} What this runner wrote last; null when it wrote nothing. */
export function resultsOf(name) {
  const { file, read } = runnerOf(name);
  return existsSync(file) ? read(readFileSync(file, 'utf8')) : null;
}

/** @param {Timed[]} tests */
export function slowest(tests, count) {
  return [...tests].sort((a, b) => b.seconds - a.seconds).slice(0, count);
}

/** One line for each step: when it began, how long it took. Steps that ran side by side overlap. */
export function stepLines(steps) {
  const seconds = (value) => value.toFixed(1).padStart(8);
  return [
    '   began    took',
    ...steps
      .toSorted((a, b) => a.began - b.began)
      .map(({ title, began, took }) => `${seconds(began)}${seconds(took)}  ${title}`),
  ];
}
