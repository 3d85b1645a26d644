import { expect, it } from 'vitest';
import { parseAdvanced } from '../../../../web/src/state/preferences.ts';
import { PRESETS } from '../../../../web/src/state/search-settings.ts';
import {
  NO_TURNS,
  PROPOSALS,
  proposalCandidates,
  weightsText,
  withWeights,
} from '../../../../web/src/ui/laboratory/proposals.ts';

it('every proposal has a preset of ours', () => {
  for (const { preset } of proposalCandidates(1)) {
    expect(PRESETS).toContain(preset);
  }
});

it('no two proposals weigh alike', () => {
  const all = proposalCandidates(1).map(({ id, preset }) => preset + weightsText(id, NO_TURNS));
  expect(new Set(all).size).toBe(PROPOSALS.length);
});

it('a slider turns its own weight by powers of two', () => {
  const usual = parseAdvanced(weightsText('simple', NO_TURNS));
  const turned = parseAdvanced(weightsText('simple', { ...NO_TURNS, beams: 3, hinges: -1 }));
  expect(turned).toEqual({ ...usual, 'weights.beams': 80, 'weights.hinges': 1.5 });
});

it('a person’s other settings stay, their weights give way', () => {
  expect(withWeights('effort=2\nweights.beams=1', 'weights.beams=10')).toBe(
    'effort=2\nweights.beams=10',
  );
});
