import { describe, expect, it } from 'vitest';
import { legalOffer } from '../../../web/src/state/legal-offer.ts';

const sketch = (lines: unknown, more: object = {}) =>
  JSON.stringify({ format: 'technic-sketch', version: 1, name: 'Rounded', lines, ...more });

const LINES = [
  { from: [0, 0, 0], to: [7.93, 0, 0], exact: true },
  { from: [7.93, 0, 0], to: [7.93, 0, 5] },
  { from: [20, 0, 0], to: [20, 0, 5] },
];

describe('the nearest drawing to one that is refused', () => {
  it('tells what changes, and keeps the rest', () => {
    const offer = legalOffer(sketch(LINES, { ground: -2 }));
    expect(offer?.sketch).toMatchObject({ name: 'Rounded', ground: -2 });
    expect(offer?.sketch.lines[0]).toEqual({ from: [0, 0, 0], to: [8, 0, 0], exact: true });
    expect(offer?.changes.map(({ line, before, after }) => [line, before, after])).toEqual([
      [0, 7.93, 8],
      [1, 5, 5],
    ]);
  });

  it.each([
    ['is no sketch', 'x'],
    ['has no lines', sketch([])],
    ['has lines that are none', sketch([{ from: [0, 0], to: [4, 0, 0] }])],
    ['has joints, which would have to move along', sketch(LINES, { joints: [] })],
    ['has a line in no plane', sketch([{ from: [0, 0, 0], to: [2, 3, 6] }])],
  ])('is none where it %s', (_name, json) => {
    expect(legalOffer(json)).toBeNull();
  });
});
