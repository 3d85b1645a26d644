import { nextPlaneMode } from '../../tools/guide.ts';
import type { PlaneMode, ToolId } from '../../tools/tool.ts';
import type { Command } from '../../ui/command.ts';
import type { IconName } from '../../ui/icon.tsx';
import { text } from '../../ui/text.ts';
import type { Actions } from '../actions.ts';

const TOOLS: readonly (readonly [ToolId, IconName, string, Command['group']])[] = [
  ['select', 'select', 'V', 'draw'],
  ['line', 'line', 'L', 'draw'],
  ['rectangle', 'rectangle', 'R', 'draw'],
  ['box', 'box', 'B', 'draw'],
  ['grid', 'grid', 'G', 'draw'],
  ['hexagon', 'hexagon', 'H', 'draw'],
  ['split', 'split', 'S', 'draw'],
  ['joint', 'joint', 'J', 'annotate'],
  ['keepOut', 'keepOut', 'K', 'annotate'],
  ['shaft', 'shaft', 'Shift+G', 'annotate'],
  ['array', 'array', 'Shift+A', 'edit'],
  ['measure', 'measure', 'D', 'view'],
];

const PLANES: readonly (readonly [string, PlaneMode, string])[] = [
  ['planeAuto', 'auto', text.commands.planeAuto],
  ['planeXY', 'z', text.commands.planeXY],
  ['planeYZ', 'x', text.commands.planeYZ],
  ['planeZX', 'y', text.commands.planeZX],
];

/** Choosing a tool, and the plane to draw on. */
export function drawCommands(actions: Actions): Command[] {
  const { state } = actions;
  return [
    ...TOOLS.map(
      ([id, icon, shortcut, group]): Command => ({
        id: `tool.${id}`,
        label: text.toolNames[id],
        group,
        icon,
        shortcut,
        checked: () => state.tool.value.id === id,
        run: () => {
          actions.useTool(id);
          actions.focusDrawing();
        },
      }),
    ),
    ...PLANES.map(
      ([id, mode, label]): Command => ({
        id,
        label,
        group: 'draw',
        icon: 'plane',
        checked: () => state.planeMode.value === mode,
        run: () => {
          state.planeMode.value = mode;
        },
      }),
    ),
    {
      id: 'planeNext',
      label: text.commands.planeNext,
      group: 'draw',
      icon: 'plane',
      shortcut: 'P',
      run: () => {
        state.planeMode.value = nextPlaneMode(state.planeMode.value);
      },
    },
  ];
}
