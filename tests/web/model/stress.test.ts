import { describe, expect, it } from 'vitest';
import {
  displacedPoint,
  fullExaggeration,
  STRESS_RAMP,
  type StressResult,
  stressColours,
  stressHex,
} from '../../../web/src/model/stress.ts';
import { stressResult } from '../helpers/stress-result.ts';

const lightness = (hex: number) =>
  0.3 * (hex >> 16) + 0.59 * ((hex >> 8) & 0xff) + 0.11 * (hex & 0xff);

describe('stress colours', () => {
  it('run from the first of the ramp to the last', () => {
    expect(stressHex(0)).toBe(STRESS_RAMP[0]);
    expect(stressHex(1)).toBe(STRESS_RAMP.at(-1));
    expect(stressHex(0.5)).toBe(STRESS_RAMP[2]);
  });

  it('cut off what is outside, and what is no number', () => {
    expect(stressHex(-1)).toBe(stressHex(0));
    expect(stressHex(7)).toBe(stressHex(1));
    expect(stressHex(Number.NaN)).toBe(stressHex(0));
  });

  it('differ in lightness from step to step', () => {
    for (let i = 1; i < STRESS_RAMP.length; i += 1) {
      const step = lightness(STRESS_RAMP[i] ?? 0) - lightness(STRESS_RAMP[i - 1] ?? 0);
      expect(Math.abs(step)).toBeGreaterThan(5);
    }
  });

  it('give the part with the greatest stress the last colour', () => {
    expect(stressColours(stressResult())).toEqual([stressHex(1), stressHex(0.25)]);
  });

  it('are those of no stress in a model that has none', () => {
    const result: StressResult = {
      ...stressResult(),
      maxStress: 0,
      parts: [{ stress: 0, safety: 1e6, utilisation: 0 }],
    };
    expect(stressColours(result)).toEqual([stressHex(0)]);
  });
});

describe('the bent shape', () => {
  it('is the model itself without exaggeration', () => {
    expect(displacedPoint([1, 2, 3, 0, 8, 8, 8], 0)).toEqual([1, 2, 3]);
  });

  it('takes displacements for millimetres, eight to a module', () => {
    expect(displacedPoint([1, 2, 3, 0, 0, 0, -4], 2)).toEqual([1, 2, 2]);
  });

  it('shows the greatest displacement as a module and a half', () => {
    const result = stressResult();
    const [, , z] = displacedPoint(
      [0, 0, 0, 0, 0, 0, -result.maxDisplacement],
      fullExaggeration(result),
    );
    expect(z).toBeCloseTo(-1.5);
  });
});
