import { expect, test } from 'vitest';
import {
  readCtest,
  readPlaywright,
  readVitest,
  slowest,
  stepLines,
} from '../../scripts/lib/test-results.mjs';

test('CTest: counts of the head, and the time of each test', () => {
  const results = readCtest(
    '<testsuite name="all" tests="4" failures="1" disabled="0" skipped="1">' +
      '<testcase name="base.A" classname="base.A" time="0.5" status="run"/>' +
      '<testcase name="base.B" classname="base.B" time="2" status="fail"></testcase></testsuite>',
  );
  expect(results).toEqual({
    passed: 2,
    failed: 1,
    skipped: 1,
    tests: [
      { name: 'base.A', seconds: 0.5 },
      { name: 'base.B', seconds: 2 },
    ],
  });
});

test('Vitest: a file that does not load counts as a failed test', () => {
  const run = { numPassedTests: 3, numFailedTests: 0, numPendingTests: 0, testResults: [] };
  const text = JSON.stringify({ ...run, numFailedTestSuites: 1, success: false });
  expect(readVitest(text).failed).toBe(1);
});

test('Vitest: tests are named by file and title', () => {
  const assertionResults = [{ fullName: 'a b', duration: 1500 }, { fullName: 'skipped' }];
  const text = JSON.stringify({
    numPassedTests: 1,
    numFailedTests: 0,
    numPendingTests: 1,
    numFailedTestSuites: 0,
    success: true,
    testResults: [{ name: '/elsewhere/a.test.ts', assertionResults }],
  });
  expect(readVitest(text).tests).toEqual([
    { name: '/elsewhere/a.test.ts: a b', seconds: 1.5 },
    { name: '/elsewhere/a.test.ts: skipped', seconds: 0 },
  ]);
});

test('Playwright: a test that passes the second time has passed, and is named, with the time of both', () => {
  const spec = {
    file: 'a.spec.ts',
    title: 'draws',
    tests: [{ status: 'flaky', results: [{ duration: 1000 }, { duration: 500 }] }],
  };
  const text = JSON.stringify({
    stats: { expected: 1, unexpected: 0, flaky: 1, skipped: 0 },
    suites: [{ specs: [], suites: [{ specs: [spec] }] }],
  });
  expect(readPlaywright(text)).toEqual({
    passed: 2,
    failed: 0,
    skipped: 0,
    second: ['a.spec.ts: draws'],
    tests: [{ name: 'a.spec.ts: draws', seconds: 1.5 }],
  });
});

test('the slowest tests come first', () => {
  const tests = [1, 3, 2].map((seconds) => ({ name: `${seconds}`, seconds }));
  expect(slowest(tests, 2).map(({ name }) => name)).toEqual(['3', '2']);
});

test('steps are told in the order in which they began', () => {
  const steps = [
    { title: 'second', began: 2, took: 1 },
    { title: 'first', began: 0.5, took: 9.25 },
  ];
  expect(stepLines(steps)).toEqual([
    '   began    took',
    '     0.5     9.3  first',
    '     2.0     1.0  second',
  ]);
});
