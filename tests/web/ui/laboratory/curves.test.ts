import { expect, it } from 'vitest';
import { ticksOf } from '../../../../web/src/ui/laboratory/curves-chart.tsx';

it('marks round values of a span', () => {
  expect(ticksOf([0, 23], {})).toEqual([0, 5, 10, 15, 20]);
  expect(ticksOf([0, 0.9], {})).toEqual([0, 0.2, 0.4, 0.6, 0.8]);
});

it('marks decades of a logarithmic span, and what lies between where there is room', () => {
  expect(ticksOf([12, 340], { logarithmic: true })).toEqual([20, 50, 100, 200]);
  expect(ticksOf([0.002, 300], { logarithmic: true })).toEqual([0.01, 0.1, 1, 10, 100]);
});
