import { describe, expect, it } from 'vitest';
import {
  MARGIN,
  PAPERS,
  pageSteps,
  partCell,
  partsOnPage,
  stepBoxes,
  wrap,
} from '../../../web/src/ui/instructions/pdf/paper.ts';

describe.each(['A4', 'Letter'] as const)('a page of %s', (paper) => {
  const [width, height] = PAPERS[paper];

  it.each([1, 2])('has room for %i steps, which do not overlap', (count) => {
    const boxes = stepBoxes(paper, count);
    expect(boxes).toHaveLength(count);
    for (const box of boxes) {
      expect(box.x).toBeGreaterThanOrEqual(MARGIN);
      expect(box.x + box.width).toBeLessThanOrEqual(width - MARGIN);
      // The page's number is below.
      expect(box.y).toBeGreaterThanOrEqual(MARGIN + 9);
      expect(box.y + box.height).toBeLessThanOrEqual(height - MARGIN);
    }
    const [upper, lower] = boxes;
    expect(upper && lower ? upper.y - (lower.y + lower.height) : 1).toBeGreaterThan(0);
  });

  it('has whole rows of parts', () => {
    expect(partsOnPage(paper) % partCell(paper, partsOnPage(paper)).columns).toBe(0);
  });

  it('has room for each number of parts, in pictures that are the larger the fewer they are', () => {
    let last = Number.POSITIVE_INFINITY;
    for (let count = 1; count <= partsOnPage(paper); count++) {
      const cell = partCell(paper, count);
      const rows = Math.ceil(count / cell.columns);
      expect(40 + rows * cell.height).toBeLessThan(height - 2 * MARGIN);
      expect(cell.columns * cell.width).toBeLessThanOrEqual(width - 2 * MARGIN + 1e-9);
      expect(cell.picture.width).toBeLessThan(cell.width);
      expect(cell.height - cell.picture.height).toBeGreaterThan(52);
      expect(cell.picture.width).toBeLessThanOrEqual(last);
      last = cell.picture.width;
    }
    expect(last).toBeGreaterThan(115);
  });
});

it('every step is on one page', () => {
  for (const count of [1, 2, 7]) {
    expect(pageSteps(count).flat()).toEqual(Array.from({ length: count }, (_, i) => i));
  }
});

const width = (line: string) => line.length;

describe('words below a part', () => {
  it.each([
    ['Beam 5, Black', 20, ['Beam 5, Black']],
    ['Pin with Friction and Slots, Black', 20, ['Pin with Friction', 'and Slots, Black']],
    ['Perpendicular', 20, ['Perpendicular']],
    ['', 20, []],
  ])('%s', (text, room, lines) => {
    expect(wrap(text, room, width)).toEqual(lines);
  });

  it('end with dots where three lines are too few, and never run out of their room', () => {
    const lines = wrap('Pin Connector Perpendicular 3 x 3 Bent 90 with 4 Pins', 15, width);
    expect(lines).toHaveLength(3);
    expect(lines[2]).toMatch(/\.\.\.$/);
    expect(Math.max(...lines.map(width))).toBeLessThanOrEqual(15);
  });
});
