import { expect, test } from 'vitest';
import { ABLATIONS, summariseAblation } from '../../scripts/lib/ablations.mjs';
import { figures, geometricMean, markdownTable, secondsText } from '../../scripts/lib/markdown.mjs';
import { inPapersCount } from '../../scripts/lib/statistics.mjs';

const run = (sketch, buildable, beams, bricks) => ({
  sketch,
  report: { buildable, beams, beamsLowerBound: 10, bricks, seconds: { processor: beams } },
});

test('beams over the bound are a mean over buildable runs alone', () => {
  const runs = [run('a', true, 10, 20), run('a', true, 12, 20), run('b', false, 30, 20)];
  expect(summariseAblation(runs, runs).overBound).toBeCloseTo(10);
});

test('a sketch that one seed failed on is unreliable, once', () => {
  const runs = [run('a', false, 10, 20), run('a', false, 12, 20), run('b', true, 30, 20)];
  expect(summariseAblation(runs, runs).unreliable).toEqual(['a']);
});

test('bricks are compared over what both could build', () => {
  const runs = [run('a', true, 10, 20), run('b', true, 10, 500)];
  const others = [run('a', true, 10, 80), run('b', false, 10, 1)];
  expect(summariseAblation(runs, others).bricks).toBeCloseTo(20);
});

test('a run that was stopped counts as not buildable', () => {
  const runs = [{ sketch: 'a', report: null }, run('b', true, 10, 20)];
  const { buildable, unreliable, seconds } = summariseAblation(runs, runs);
  expect([buildable, unreliable, seconds]).toEqual([1, ['a'], 10]);
});

test('the whole search is the first row and switches nothing off', () => {
  expect(ABLATIONS[0].set).toEqual([]);
  expect(ABLATIONS.slice(1).every(({ set }) => set.length > 0)).toBe(true);
});

test('every row has a key of its own', () => {
  expect(new Set(ABLATIONS.map(({ key }) => key)).size).toBe(ABLATIONS.length);
});

test('a table has a rule under its titles', () => {
  expect(markdownTable(['a', 'b'], [['1', '2']])).toBe('| a | b |\n| --- | ---: |\n| 1 | 2 |');
});

test('figures come in the order of the design', () => {
  expect(figures({ beams: 1, bricks: 2, gaps: 3, collisions: 4, failedConnections: 5 })).toBe(
    '1 / 2 / 3 / 4 / 5',
  );
});

test('a gap that a spacer fills is one in the count of the paper', () => {
  expect(inPapersCount({ beams: 3, gaps: 1, filledGaps: 2 })).toMatchObject({ beams: 3, gaps: 3 });
});

test('the geometric mean of a ratio and its inverse is one', () => {
  expect(geometricMean([4, 0.25])).toBeCloseTo(1);
  expect(geometricMean([Number.NaN])).toBeNull();
});

test('seconds that are missing are a dash', () => {
  expect([secondsText(null), secondsText(0.123), secondsText(12.3)]).toEqual(['-', '0.12', '12']);
});
