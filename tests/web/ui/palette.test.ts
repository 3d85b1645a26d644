import { describe, expect, it } from 'vitest';
import type { Command } from '../../../web/src/ui/command.ts';
import { searchCommands } from '../../../web/src/ui/palette.tsx';
import { chartPath, termCurves } from '../../../web/src/ui/progress-chart.tsx';

const command = (id: string, label: string): Command => ({
  id,
  label,
  group: 'edit',
  icon: 'copy',
  run: () => undefined,
});
const COMMANDS = [command('a', 'Redo'), command('b', 'Undo'), command('c', 'Mirror across X')];

describe('palette', () => {
  it('shows everything in its order without a search', () => {
    expect(searchCommands(COMMANDS, ' ')).toEqual(COMMANDS);
  });

  it('finds all words in any order and case', () => {
    expect(searchCommands(COMMANDS, 'x MIRR').map(({ id }) => id)).toEqual(['c']);
  });

  it('puts what begins with the word first', () => {
    expect(searchCommands(COMMANDS, 'do').map(({ id }) => id)).toEqual(['a', 'b']);
    expect(searchCommands(COMMANDS, 'un').map(({ id }) => id)).toEqual(['b']);
  });
});

describe('chart', () => {
  const at = (iterations: number, terms: Record<string, number> = {}) => ({
    iterations,
    objective: 2,
    temperature: 1,
    beams: 3,
    gaps: 0,
    collisions: 0,
    failedConnections: 0,
    terms,
  });

  it('shows the largest terms of the objective first, and none that stay nothing', () => {
    const curves = termCurves([at(0, { beams: 5, hinges: 0, holes: 1 }), at(9, { holes: 7 })]);
    expect(curves.map(({ look }) => look)).toEqual(['term term-1', 'term term-2']);
    expect(curves.map(({ value }) => value(at(3, { beams: 1, holes: 2 })))).toEqual([2, 1]);
  });

  it('stays in its box for a flat curve', () => {
    const path = chartPath([at(0), at(10)], (point) => point.objective, [2, 2], 50);
    expect(path).not.toContain('NaN');
  });
});
