import { describe, expect, it } from 'vitest';
import type { SketchFault } from '../../../web/src/state/sketch-faults.ts';
import { faultSentence, mendWords, placesInWords } from '../../../web/src/ui/fault-words.ts';

describe('a sentence of the core', () => {
  it('counts lines from one and names their ends', () => {
    expect(placesInWords('lines[0].from was moved by 0.03 modules; see lines[12]')).toBe(
      'The start of line 1 was moved by 0.03 modules; see line 13.',
    );
  });

  it('that ends as one already is left so', () => {
    expect(placesInWords('Nothing is wrong.')).toBe('Nothing is wrong.');
  });
});

const NEAR: SketchFault = {
  kind: 'pieces',
  message: 'the piece of lines[1] is 12 modules from the piece of lines[0]',
  at: [8, 0, 0],
  lines: [1, 0],
  mend: [{ from: [8, 0, 0], to: [20, 0, 0] }],
};

describe('a fault of the drawing', () => {
  it('is said in one sentence', () => {
    expect(faultSentence(NEAR)).toBe('The piece of line 2 is 12 modules from the piece of line 1.');
  });

  it('is mended by a line, or by a shift', () => {
    const shift = { ...NEAR, mend: [{ line: 1, from: [8, 0, 0], to: [14, 0, 0] }] } as const;
    expect(mendWords(NEAR)).not.toBe(mendWords(shift));
  });
});
