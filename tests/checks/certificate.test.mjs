import { expect, test } from 'vitest';
import { faultOf } from '../../scripts/check-certificate.mjs';

// Two lines of two edges each that meet: a corner part covers both inner edges, straight ones a line each.
const PLACEMENTS = {
  runs: [{}, {}],
  edges: [
    { run: 0, index: 0 },
    { run: 0, index: 1 },
    { run: 1, index: 0 },
    { run: 1, index: 1 },
  ],
  covers: [
    { kind: 'straight', part: 'a', parts: 1, runs: [0], edges: [0, 1] },
    { kind: 'straight', part: 'a', parts: 1, runs: [1], edges: [2, 3] },
    { kind: 'bent', part: 'b', parts: 1, runs: [0, 1], edges: [1, 2] },
  ],
  rivals: [],
  limits: [],
};

function certificate(bound, tree, unit = 4) {
  return {
    format: 'liftarm-certificate',
    version: 1,
    name: 'corner',
    bound,
    unit,
    pieces: [{ bound, tree }],
  };
}

const leaf = (prices, branchPrices = []) => ({ prices, branchPrices });
const LEAF = leaf([
  [0, 4],
  [3, 4],
]);

test('prices that prove the bound are taken', () => {
  expect(faultOf(PLACEMENTS, certificate(2, LEAF))).toBeNull();
});

test('a bound above what the prices prove is refused', () => {
  expect(faultOf(PLACEMENTS, certificate(3, LEAF))).toMatch(/does not prove 3/);
});

test('a price that is too high takes off what it adds', () => {
  const greedy = leaf([0, 1, 2, 3].map((row) => [row, 4]));
  expect(faultOf(PLACEMENTS, certificate(2, greedy))).toMatch(/does not prove/);
});

test('a negative price is refused', () => {
  const tree = leaf([
    [0, 4],
    [3, 8],
    [1, -4],
  ]);
  expect(faultOf(PLACEMENTS, certificate(2, tree))).toMatch(/price that is none/);
});

test('a price on the wrong edge proves less', () => {
  const tree = leaf([
    [1, 4],
    [2, 4],
  ]);
  expect(faultOf(PLACEMENTS, certificate(2, tree))).toMatch(/does not prove/);
});

test('a row that is not there, or twice, is refused', () => {
  expect(faultOf(PLACEMENTS, certificate(1, leaf([[9, 4]])))).toMatch(/row that is none/);
  const twice = leaf([
    [0, 4],
    [0, 4],
  ]);
  expect(faultOf(PLACEMENTS, certificate(2, twice))).toMatch(/row that is none/);
});

test('a leaf that a branch has not is missed', () => {
  const tree = { rows: [0], most: 1, fewer: leaf(LEAF.prices, [0]) };
  expect(faultOf(PLACEMENTS, certificate(2, tree))).toMatch(/incomplete/);
});

test('both sides of a branch are looked at', () => {
  const good = leaf(LEAF.prices, [0]);
  const bad = leaf([[0, 4]], [0]);
  const tree = (fewer, more) => certificate(2, { rows: [1, 2], most: 0, fewer, more });
  expect(faultOf(PLACEMENTS, tree(good, good))).toBeNull();
  expect(faultOf(PLACEMENTS, tree(good, bad))).toMatch(/does not prove/);
  expect(faultOf(PLACEMENTS, tree(bad, good))).toMatch(/does not prove/);
});

test('the price of a branch works on its side alone', () => {
  // At least one corner part: it costs one, and the outer edges need two more parts.
  const more = leaf(LEAF.prices, [4]);
  const fewer = leaf(LEAF.prices, [4]);
  const branch = { rows: [1, 2], most: 0, fewer, more };
  expect(faultOf(PLACEMENTS, certificate(2, branch))).toBeNull();
  const three = { ...certificate(3, branch) };
  expect(faultOf(PLACEMENTS, three)).toMatch(/does not prove 3/);
});

test('pieces must add up, and no cover may pay in two', () => {
  const two = {
    ...certificate(4, LEAF),
    pieces: [
      { bound: 2, tree: LEAF },
      { bound: 2, tree: LEAF },
    ],
  };
  expect(faultOf(PLACEMENTS, two)).toMatch(/two pieces/);
  expect(faultOf(PLACEMENTS, { ...certificate(2, LEAF), bound: 3 })).toMatch(
    /pieces prove 2, not 3/,
  );
});

test('rivals and limits hold a choice back', () => {
  // Axles alone could cover, but only one of them can be there: with the limit none is left.
  const placements = {
    ...PLACEMENTS,
    covers: PLACEMENTS.covers.map((cover, i) => (i < 2 ? { ...cover, part: 'axle' } : cover)),
    rivals: [[0, 1]],
    limits: [{ part: 'axle', owned: 1 }],
  };
  const prices = (row) =>
    leaf([
      [0, 40],
      [3, 40],
      [row, 36],
    ]);
  // Rows: four edges, two runs, then the rivals and the limit.
  expect(faultOf(placements, certificate(11, prices(6)))).toBeNull();
  expect(faultOf(placements, certificate(11, prices(7)))).toBeNull();
  expect(faultOf(PLACEMENTS, certificate(11, prices(0)))).not.toBeNull();
});
