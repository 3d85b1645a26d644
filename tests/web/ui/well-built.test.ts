import { describe, expect, it } from 'vitest';
import type { WellBuiltItem } from '../../../web/src/model/report.ts';
import { builtNumber, litParts } from '../../../web/src/ui/checks/well-built.ts';

const item = (id: string, more: Partial<WellBuiltItem> = {}): WellBuiltItem => ({
  id,
  title: '',
  ok: false,
  applies: true,
  detail: '',
  figures: {},
  places: [],
  ...more,
});

describe('what an item says beside its name', () => {
  it('is its number', () => {
    expect(builtNumber(item('faithful', { figures: { meanLayer: 0.736 } }))).toBe(
      '0.74 layers off',
    );
    expect(builtNumber(item('clean', { figures: { nakedHeads: 3, heads: 40 } }))).toBe(
      '3 of 40 in nothing',
    );
  });

  it('names only what falls short', () => {
    const figures = { fallsOver: 1, belowBase: 0, liftedFeet: 2 };
    expect(builtNumber(item('stands', { figures }))).toBe('falls over, 2 feet in the air');
    expect(builtNumber(item('stiff', { figures: { freedomsBeyondJoints: 0 } }))).toBe('good');
  });

  it('is no number where nothing is asked', () => {
    expect(builtNumber(item('symmetric', { applies: false, ok: true }))).toBe('not asked for');
  });
});

describe('what an item lights', () => {
  const places = [
    { kind: 'nakedHead', message: 'a', parts: [3] },
    { kind: 'nakedHead', message: 'b', parts: [4, 5] },
  ];

  it('is the parts of all its places, or of the one pressed', () => {
    expect([...litParts(item('clean', { places }), null)]).toEqual([3, 4, 5]);
    expect([...litParts(item('clean', { places }), 1)]).toEqual([4, 5]);
  });

  it('is nothing where a place has no part', () => {
    expect(litParts(item('stands', { places: [{ kind: 'fallsOver', message: '' }] }), 0).size).toBe(
      0,
    );
  });
});
