import { describe, expect, it } from 'vitest';
import { sketchPoints } from '../../../web/src/model/bounds.ts';
import type { SketchDocument } from '../../../web/src/model/sketch.ts';

const SKETCH: SketchDocument = {
  format: 'technic-sketch',
  version: 1,
  lines: [{ from: [0, 0, 0], to: [4, 0, 0] }],
  keepOut: [{ min: [1, 2, 3], max: [5, 6, 30] }],
};

describe('what a picture of a sketch is fitted to', () => {
  it('is its lines and its keep-out boxes', () => {
    expect(sketchPoints(SKETCH)).toEqual([
      [0, 0, 0],
      [4, 0, 0],
      [1, 2, 3],
      [5, 6, 30],
    ]);
  });

  it('is nothing where there is no sketch', () => {
    expect(sketchPoints(null)).toEqual([]);
  });
});
