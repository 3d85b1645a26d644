import { describe, expect, it } from 'vitest';
import { wrap } from '../../../web/src/ui/instructions/pdf/paper.ts';

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

  it('end with dots where two lines are too few, and never run out of their room', () => {
    const lines = wrap('Pin Connector Perpendicular 3 x 3 Bent 90 with 4 Pins', 20, width);
    expect(lines).toHaveLength(2);
    expect(lines[1]).toMatch(/\.\.\.$/);
    expect(Math.max(...lines.map(width))).toBeLessThanOrEqual(20);
  });
});
