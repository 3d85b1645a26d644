import { expect, test } from 'vitest';
import { beamsOverBound, csvField, median, summarise } from '../../scripts/lib/statistics.mjs';

const run = (ok, beams, seconds) => ({
  ok,
  report: { beams, beamsLowerBound: 10, gaps: ok ? 0 : 2, seconds: { total: seconds } },
  wallSeconds: seconds + 1,
  failure: ok ? '' : 'seed 2: node (1,2,3) has a gap',
});

test('the median of an even count is the mean of the middle two', () => {
  expect(median([4, 1, 3, 2])).toBe(2.5);
  expect(median([3, 1, 2])).toBe(2);
});

test('the median leaves out runs that gave no number', () => {
  expect(median([undefined, 5, Number.NaN])).toBe(5);
  expect(median([undefined])).toBeNull();
});

test('a row counts successes and shows the worst seed', () => {
  const row = summarise('bow', [run(true, 12, 1), run(false, 11, 3), run(true, 13, 2)]);
  expect(row).toMatchObject({ runs: 3, ok: 2, beamsMin: 11, beamsMedian: 12, gaps: 2, seconds: 2 });
  expect(row.failure).toContain('has a gap');
});

test('a crashed run without a report does not disturb the others', () => {
  const crash = { ok: false, report: null, wallSeconds: 0, failure: 'seed 1: SIGSEGV' };
  expect(summarise('bow', [crash, run(true, 12, 1)])).toMatchObject({ ok: 1, beamsMedian: 12 });
});

test('a run is rigid only when it is a success without freedoms; the loosest shows', () => {
  const loose = (ok, freedomsBeyondJoints) => ({
    ...run(ok, 12, 1),
    report: { freedomsBeyondJoints },
  });
  const row = summarise('bow', [loose(true, 0), loose(true, 3), loose(false, 0)]);
  expect(row).toMatchObject({ rigid: 1, loose: 3 });
});

test('beams over the bound are a percentage, and nothing where there is no bound', () => {
  expect(beamsOverBound({ beamsMedian: 11, bound: 10 })).toBeCloseTo(10);
  expect(beamsOverBound({ beamsMedian: 11, bound: null })).toBeNull();
});

test('CSV fields with commas and quotes are quoted', () => {
  expect(csvField('a,"b"')).toBe('"a,""b"""');
  expect(csvField(null)).toBe('');
});
