import loadHighs from 'highs';
import { expect, test } from 'vitest';
// @ts-expect-error: a script without types, on purpose: it shares nothing with the prover
import { faultOf } from '../../../../scripts/check-certificate.mjs';
import type { ProofTree } from '../../../../web/src/solver/proof/certificate.ts';
import type { PlacedCover, Placements } from '../../../../web/src/solver/proof/placements.ts';
import { PROOF_DEFAULTS, prove } from '../../../../web/src/solver/proof/prove.ts';

const highs = await loadHighs();

function placements(edges: number, covers: readonly (readonly number[])[]): Placements {
  return {
    format: 'liftarm-placements',
    version: 1,
    name: 'test',
    runs: [],
    edges: Array.from({ length: edges }, (_, index) => ({ run: 0, index })),
    covers: covers.map(
      (list): PlacedCover => ({ kind: 'straight', part: 'p', parts: 1, runs: [], edges: list }),
    ),
    rivals: [],
    limits: [],
    quickBound: 0,
  };
}

/** Every two of n edges have a cover of their own: the linear optimum is n / 2. */
function everyTwo(n: number, first = 0): number[][] {
  const all = Array.from({ length: n }, (_, i) => first + i);
  return all.flatMap((a) => all.filter((b) => b > a).map((b) => [a, b]));
}

function leavesOf(tree: ProofTree): number {
  return 'prices' in tree ? 1 : leavesOf(tree.fewer) + leavesOf(tree.more);
}

test('the linear optimum rounded up is proved by one leaf', () => {
  const asked = placements(5, everyTwo(5));
  const certificate = prove(asked, highs);
  expect(certificate.bound).toBe(3);
  expect(certificate.pieces.map(({ tree }) => leavesOf(tree))).toEqual([1]);
  expect(faultOf(asked, certificate)).toBeNull();
});

/**
 * The plane of nine points: an edge for each of its twelve lines, a cover for each point on the lines through
 * it. The linear optimum is 3, the whole one 5 (a set that no line misses).
 */
function planeOfNine(): Placements {
  const numbers = [0, 1, 2];
  // a x + b y = c for each of four directions.
  const directions = [
    [1, 0],
    [0, 1],
    [1, 1],
    [1, 2],
  ] as const;
  const lines = numbers.flatMap((c) => directions.map(([a, b]) => ({ a, b, c })));
  const covers = numbers.flatMap((x) =>
    numbers.map((y) =>
      lines.flatMap(({ a, b, c }, edge) => ((a * x + b * y) % 3 === c ? [edge] : [])),
    ),
  );
  return placements(lines.length, covers);
}

test('what one leaf cannot prove takes branches', () => {
  const certificate = prove(planeOfNine(), highs);
  expect(certificate.bound).toBe(5);
  expect(leavesOf((certificate.pieces[0] as { tree: ProofTree }).tree)).toBeGreaterThan(1);
  expect(faultOf(planeOfNine(), certificate)).toBeNull();
});

test('where leaves run out it says what the root proves', () => {
  const certificate = prove(planeOfNine(), highs, { ...PROOF_DEFAULTS, leaves: 0 });
  expect(certificate.bound).toBe(3);
  expect(faultOf(planeOfNine(), certificate)).toBeNull();
});

test('pieces are proved one by one', () => {
  const two = placements(6, [...everyTwo(3), ...everyTwo(3, 3)]);
  const certificate = prove(two, highs);
  expect(certificate.pieces.map(({ bound }) => bound)).toEqual([2, 2]);
  expect(certificate.bound).toBe(4);
  expect(faultOf(two, certificate)).toBeNull();
});

test('a limit on a part is obeyed', () => {
  const wide = placements(2, [[0, 1], [0], [1]]);
  const held: Placements = {
    ...wide,
    covers: wide.covers.map((cover, i) => ({ ...cover, part: i === 0 ? 'wide' : 'narrow' })),
    limits: [{ part: 'wide', owned: 0 }],
  };
  expect(prove(wide, highs).bound).toBe(1);
  expect(prove(held, highs).bound).toBe(2);
  expect(faultOf(held, prove(held, highs))).toBeNull();
  expect(faultOf(wide, prove(held, highs))).not.toBeNull();
});

test('rivals are obeyed', () => {
  const asked = placements(2, [[0], [1], [0], [1]]);
  const rival: Placements = {
    ...asked,
    covers: asked.covers.map((cover, i) => (i < 2 ? cover : { ...cover, parts: 3 })),
    rivals: [[0, 1]],
  };
  expect(prove(rival, highs).bound).toBe(4);
  expect(faultOf(rival, prove(rival, highs))).toBeNull();
});
