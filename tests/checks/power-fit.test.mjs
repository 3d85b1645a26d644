import assert from 'node:assert/strict';
import { test } from 'vitest';
import { fitPower } from '../../scripts/lib/power-fit.mjs';

test('finds the exponent and the factor of an exact power law', () => {
  const fit = fitPower([1, 2, 5, 10].map((x) => ({ x, y: 3 * x ** 1.5 })));
  assert.ok(Math.abs(fit.exponent - 1.5) < 1e-12);
  assert.ok(Math.abs(fit.factor - 3) < 1e-12);
  assert.ok(Math.abs(fit.rSquared - 1) < 1e-12);
});

test('finds the exponent 0 of times that do not grow', () => {
  assert.equal(fitPower([1, 2, 4].map((x) => ({ x, y: 7 }))).exponent, 0);
});

test('passes over what has no logarithm', () => {
  const points = [
    { x: 1, y: 2 },
    { x: 2, y: 4 },
    { x: 0, y: 1 },
    { x: 3, y: Number.NaN },
  ];
  assert.ok(Math.abs(fitPower(points).exponent - 1) < 1e-12);
});

test('needs two different lengths', () => {
  assert.equal(fitPower([{ x: 2, y: 3 }]), null);
  assert.equal(
    fitPower([
      { x: 2, y: 3 },
      { x: 2, y: 4 },
    ]),
    null,
  );
});
