import { describe, expect, it } from 'vitest';
import {
  CELL,
  FEWEST,
  type GridBeam,
  holesBetween,
  isBeam,
  scoreOf,
} from '../../../web/src/ui/lessons/grid-puzzle.ts';

/** Whole lines of nine holes: rows below, columns above. */
function twoByTwo(): GridBeam[] {
  return [0, 4, 8].flatMap((at) => [
    { from: { x: 0, y: at }, to: { x: 8, y: at }, layer: 0 },
    { from: { x: at, y: 0 }, to: { x: at, y: 8 }, layer: 1 },
  ]);
}

describe('the grid puzzle', () => {
  it('is complete with the fewest beams on 2 x 2', () => {
    expect(scoreOf(2, twoByTwo())).toEqual({
      beams: FEWEST[2],
      uncovered: 0,
      collisions: 0,
      gaps: 0,
      pieces: 1,
      complete: true,
    });
  });

  it('counts a collision where two beams share a place', () => {
    const beams = twoByTwo().map((beam) => ({ ...beam, layer: 0 }));
    expect(scoreOf(2, beams)).toMatchObject({ collisions: 9, complete: false });
  });

  it('counts a gap for each empty layer in a stack', () => {
    const beams = twoByTwo().map((beam) => ({ ...beam, layer: 2 * beam.layer }));
    expect(scoreOf(2, beams)).toMatchObject({ gaps: 9, complete: false });
  });

  it('counts the edges of the grid', () => {
    expect(scoreOf(4, []).uncovered).toBe(2 * 5 * 4 * CELL);
  });

  it('counts pieces that nothing joins', () => {
    expect(
      scoreOf(
        2,
        twoByTwo().filter((beam) => beam.layer === 0),
      ).pieces,
    ).toBe(3);
  });

  it.each([
    [{ x: 0, y: 0 }, { x: 8, y: 0 }, 9],
    [{ x: 4, y: 8 }, { x: 4, y: 2 }, 7],
    [{ x: 1, y: 1 }, { x: 5, y: 1 }, 0],
    [{ x: 0, y: 0 }, { x: 4, y: 4 }, 0],
  ])('knows beams from %o to %o', (from, to, holes) => {
    expect(holesBetween(from, to)).toBe(holes);
  });

  it('has beams of 2, 3, 5, 7 and 9 holes only', () => {
    expect([1, 2, 3, 4, 5, 6, 7, 8, 9, 11].filter(isBeam)).toEqual([2, 3, 5, 7, 9]);
  });
});
