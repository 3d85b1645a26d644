import { describe, expect, it } from 'vitest';
import type { Command } from '../../../web/src/ui/command.ts';
import { searchCommands } from '../../../web/src/ui/palette.tsx';
import { chartPath } from '../../../web/src/ui/progress-chart.tsx';

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
  it('stays in its box for a flat curve', () => {
    const tallies = { temperature: 1, beams: 3, gaps: 0, collisions: 0, failedConnections: 0 };
    const points = [0, 10].map((iterations) => ({ iterations, objective: 2, ...tallies }));
    const path = chartPath(points, (point) => point.objective, [2, 2], 50);
    expect(path).not.toContain('NaN');
  });
});
