import { expect, test } from 'vitest';
import { refusedLine } from '../../../web/src/app/page-state.ts';
import { keptLayouts, MAX_LAYOUTS } from '../../../web/src/app/solve-run.ts';
import { PREFERENCE_DEFAULTS } from '../../../web/src/state/preferences.ts';
import { settingsOf } from '../../../web/src/ui/solve-settings.ts';

test('a person who has set nothing asks for the defaults of the core', () => {
  expect(settingsOf(PREFERENCE_DEFAULTS)).toEqual({ seed: 1, preset: 'balanced', set: {} });
});

test('single options win over the pictures', () => {
  const preferences = { ...PREFERENCE_DEFAULTS, effort: 4, off: ['32278'], advanced: 'effort=2' };
  expect(settingsOf(preferences).set).toEqual({ effort: 2, lengths: '2,3,5,6,7,9,11,13' });
});

test('counts of owned parts limit the search', () => {
  const preferences = { ...PREFERENCE_DEFAULTS, owned: { '32278': 4, '2780': 30 } };
  expect(settingsOf(preferences).set).toEqual({ 'owned.32278': 4, 'owned.2780': 30 });
});

test('a refusal of the core names its line', () => {
  expect(refusedLine('lines[3]: length 4.5 is not a whole number of modules')).toBe(3);
  expect(refusedLine('the sketch has no lines')).toBeNull();
});

test('of many layouts the first and the last are kept, and never more than a few', () => {
  const layout = (iterations: number) => ({
    iterations,
    objective: 1,
    temperature: 1,
    beams: 1,
    gaps: 0,
    collisions: 0,
    failedConnections: 0,
    terms: {},
    json: '{}',
  });
  let kept = [layout(0)] as readonly ReturnType<typeof layout>[];
  for (let i = 1; i <= 100; i++) {
    kept = keptLayouts([...kept, layout(i)]);
    expect(kept.length).toBeLessThanOrEqual(MAX_LAYOUTS);
    expect([kept[0]?.iterations, kept.at(-1)?.iterations]).toEqual([0, i]);
  }
});
