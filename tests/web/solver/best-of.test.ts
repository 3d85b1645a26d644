import { expect, test } from 'vitest';
import { isBetter, standingOf } from '../../../web/src/solver/best-of.ts';
import cases from '../../contract/best-of.json' with { type: 'json' };

test.each(cases)('$about', ({ reports, best }) => {
  const ranked = reports.map(standingOf).sort((a, b) => (isBetter(a, b) ? -1 : 1));
  expect(ranked[0]?.seed).toBe(best);
});

test('a result never goes before itself', () => {
  const standing = standingOf({ buildable: true, beams: 12, bricks: 30, seed: 4 });
  expect(isBetter(standing, standing)).toBe(false);
});
