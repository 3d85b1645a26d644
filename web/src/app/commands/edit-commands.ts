import { type AxisName, add, scale, subtract, type Vec3 } from '../../geometry/vec.ts';
import { boundsOfPoints } from '../../model/bounds.ts';
import { lineLength, type SketchLine } from '../../model/sketch.ts';
import { chainedLines, connectedLines, joinLines } from '../../state/connectivity.ts';
import { copyLines } from '../../state/copy-lines.ts';
import { type LineMap, mapLines, mirrorAt, quarterTurn, removeLines } from '../../state/edits.ts';
import { mirrorPlace } from '../../state/mirror-place.ts';
import { fillWords } from '../../tools/tool-words.ts';
import type { Command } from '../../ui/command.ts';
import { text } from '../../ui/text.ts';
import type { Actions } from '../actions.ts';
import { pasteLines, selectedLines } from '../clipboard.ts';

/** Undo, clipboard, and everything that changes the selected lines. */
export function editCommands(actions: Actions): Command[] {
  return [
    ...historyCommands(actions),
    ...selectionCommands(actions),
    ...clipboardCommands(actions),
    ...transformCommands(actions),
  ];
}

function historyCommands({ state, undo, redo }: Actions): Command[] {
  return [
    {
      id: 'undo',
      label: text.commands.undo,
      group: 'edit',
      icon: 'undo',
      shortcut: 'Mod+Z',
      when: () => state.store.canUndo.value,
      run: undo,
    },
    {
      id: 'redo',
      label: text.commands.redo,
      group: 'edit',
      icon: 'redo',
      shortcut: 'Mod+Shift+Z',
      when: () => state.store.canRedo.value,
      run: redo,
    },
  ];
}

const STEPS: readonly (readonly [string, number, string, string])[] = [
  ['selectNext', 1, text.commands.selectNext, '.'],
  ['selectPrevious', -1, text.commands.selectPrevious, ','],
];

/** Selects the line after or before the selected one, round and round, and says which it is. */
function selectBeside(actions: Actions, step: number): void {
  const { store } = actions.state;
  const count = store.sketch.value.lines.length;
  const [now = step > 0 ? -1 : 0] = store.selection.value;
  const index = (now + step + count) % count;
  if (actions.state.tool.value.id !== 'select') {
    actions.useTool('select');
  }
  store.select([index]);
  const line = store.sketch.value.lines[index];
  if (line) {
    const place = (point: Vec3) => point.map((value) => Math.round(value * 100) / 100).join(', ');
    actions.announce(
      fillWords(text.draw.lineChosen, {
        i: index + 1,
        n: Math.round(lineLength(line)),
        from: place(line.from),
        to: place(line.to),
      }),
    );
  }
}

function selectionCommands(actions: Actions): Command[] {
  const { store } = actions.state;
  const some = () => store.selection.value.size > 0;
  const any = () => store.sketch.value.lines.length > 0;
  const row = { group: 'edit', icon: 'select' } as const;
  return [
    {
      ...row,
      id: 'delete',
      label: text.commands.delete,
      icon: 'trash',
      shortcut: 'Delete',
      when: some,
      run: () =>
        actions.edit(text.edits.delete, removeLines(store.sketch.value, store.selection.value)),
    },
    {
      ...row,
      id: 'selectAll',
      label: text.commands.selectAll,
      icon: 'all',
      shortcut: 'Mod+A',
      when: any,
      run: () => {
        actions.useTool('select');
        store.select(store.sketch.value.lines.keys());
      },
    },
    {
      ...row,
      id: 'selectConnected',
      label: text.commands.selectConnected,
      shortcut: 'C',
      when: some,
      run: () => store.select(connectedLines(store.sketch.value, store.selection.value)),
    },
    ...STEPS.map(
      ([id, step, label, shortcut]): Command => ({
        ...row,
        id,
        label,
        shortcut,
        when: any,
        run: () => selectBeside(actions, step),
      }),
    ),
    {
      ...row,
      id: 'selectChain',
      label: text.commands.selectChain,
      shortcut: 'Shift+C',
      when: some,
      run: () => store.select(chainedLines(store.sketch.value, store.selection.value)),
    },
    {
      ...row,
      id: 'join',
      label: text.commands.join,
      icon: 'merge',
      when: () => store.selection.value.size > 1,
      run: () =>
        actions.edit(text.edits.join, joinLines(store.sketch.value, store.selection.value)),
    },
  ];
}

function clipboardCommands(actions: Actions): Command[] {
  const { store } = actions.state;
  const some = () => store.selection.value.size > 0;
  const chosen = () => selectedLines(store.sketch.value, store.selection.value);
  const paste = (label: string, lines: readonly SketchLine[]) => {
    const pasted = pasteLines(store.sketch.value, lines);
    actions.edit(label, pasted.sketch);
    actions.useTool('select');
    store.select(pasted.added);
  };
  const copy = () => {
    actions.clipboard = chosen();
  };
  const row = { group: 'edit', icon: 'copy' } as const;
  return [
    { ...row, id: 'copy', label: text.commands.copy, shortcut: 'Mod+C', when: some, run: copy },
    {
      ...row,
      id: 'cut',
      label: text.commands.cut,
      shortcut: 'Mod+X',
      when: some,
      run: () => {
        copy();
        actions.edit(text.edits.cut, removeLines(store.sketch.value, store.selection.value));
      },
    },
    {
      ...row,
      id: 'paste',
      label: text.commands.paste,
      icon: 'paste',
      shortcut: 'Mod+V',
      run: () => paste(text.edits.paste, actions.clipboard),
    },
    {
      ...row,
      id: 'duplicate',
      label: text.commands.duplicate,
      shortcut: 'Mod+D',
      when: some,
      run: () => paste(text.edits.duplicate, chosen()),
    },
  ];
}

const MIRRORS: readonly (readonly [string, AxisName, string, string | undefined])[] = [
  ['mirrorX', 'x', text.commands.mirrorX, 'M'],
  ['mirrorY', 'y', text.commands.mirrorY, 'Shift+M'],
  ['mirrorZ', 'z', text.commands.mirrorZ, undefined],
];

const TURNS: readonly (readonly [string, AxisName, string, string | undefined])[] = [
  ['rotateX', 'x', text.commands.rotateX, undefined],
  ['rotateY', 'y', text.commands.rotateY, undefined],
  ['rotateZ', 'z', text.commands.rotateZ, 'Shift+R'],
];

const SCALES: readonly (readonly [string, number, string])[] = [
  ['double', 2, text.commands.double],
  ['triple', 3, text.commands.triple],
  ['halve', 0.5, text.commands.halve],
];

/** Whether lines stay of whole length under a scale. */
function fits(factor: number): (line: SketchLine) => boolean {
  return (line) => {
    const size = lineLength(line) * factor;
    return size > 0.5 && Math.abs(size - Math.round(size)) < 1e-3;
  };
}

/** A scale that keeps one corner where it is. */
function scaleFrom(factor: number, corner: Vec3): LineMap {
  return {
    point: (p) => add(corner, scale(subtract(p, corner), factor)),
    axis: (axis) => axis,
  };
}

function transformCommands(actions: Actions): Command[] {
  const { store, offsetOpen } = actions.state;
  const some = () => store.selection.value.size > 0;
  const middle = () => wholeMiddle(selectedLines(store.sketch.value, store.selection.value));
  const corner = () =>
    boundsOfPoints(
      selectedLines(store.sketch.value, store.selection.value).flatMap((l) => [l.from, l.to]),
    )?.min ?? [0, 0, 0];
  const inPlace = (label: string, map: LineMap) =>
    actions.edit(label, mapLines(store.sketch.value, store.selection.value, map));
  return [
    {
      id: 'offset',
      label: text.commands.offset,
      group: 'edit',
      icon: 'offset',
      shortcut: 'Shift+O',
      when: some,
      checked: () => offsetOpen.value,
      run: () => {
        actions.useTool('select');
        offsetOpen.value = !offsetOpen.value;
      },
    },
    ...MIRRORS.map(
      ([id, axis, label, shortcut]): Command => ({
        id,
        label,
        group: 'edit',
        icon: 'mirror',
        ...(shortcut ? { shortcut } : {}),
        when: some,
        run: () => mirrorCopy(actions, axis),
      }),
    ),
    ...TURNS.map(
      ([id, axis, label, shortcut]): Command => ({
        id,
        label,
        group: 'edit',
        icon: 'rotate',
        ...(shortcut ? { shortcut } : {}),
        when: some,
        run: () => inPlace(text.edits.rotate, quarterTurn(axis, middle())),
      }),
    ),
    ...SCALES.map(
      ([id, factor, label]): Command => ({
        id,
        label,
        group: 'edit',
        icon: 'explode',
        when: () =>
          some() && selectedLines(store.sketch.value, store.selection.value).every(fits(factor)),
        run: () => inPlace(text.edits.scale, scaleFrom(factor, corner())),
      }),
    ),
  ];
}

/** Adds the mirror image; see mirrorPlace() for where the mirror stands. */
function mirrorCopy(actions: Actions, axis: AxisName): void {
  const { store } = actions.state;
  const sketch = store.sketch.value;
  const mirror = mirrorAt(axis, mirrorPlace(sketch, store.selection.value, axis));
  actions.edit(text.edits.mirror, copyLines(sketch, store.selection.value, [mirror]).sketch);
}

/** The middle of some lines, moved to the lattice so that whole points turn into whole points. */
function wholeMiddle(lines: readonly SketchLine[]): Vec3 {
  const box = boundsOfPoints(lines.flatMap((line) => [line.from, line.to]));
  const middle = (k: 0 | 1 | 2) => (box ? Math.round((box.min[k] + box.max[k]) / 2) : 0);
  return [middle(0), middle(1), middle(2)];
}
