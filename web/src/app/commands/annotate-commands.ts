import type { AxisName } from '../../geometry/vec.ts';
import { sketchBounds } from '../../model/bounds.ts';
import type { SketchDocument } from '../../model/sketch.ts';
import { setExact, setGround, setHoleAxis } from '../../state/edits.ts';
import { clearShafts, withEnds } from '../../state/shaft-edits.ts';
import type { Command } from '../../ui/command.ts';
import { text } from '../../ui/text.ts';
import type { Actions } from '../actions.ts';

const HOLE_AXES: readonly (readonly [string, AxisName | null, string])[] = [
  ['holeAxisX', 'x', text.commands.holeAxisX],
  ['holeAxisY', 'y', text.commands.holeAxisY],
  ['holeAxisZ', 'z', text.commands.holeAxisZ],
  ['holeAxisAuto', null, text.commands.holeAxisAuto],
];

/** Exact lines, hole axes, ground and keep-out boxes. */
export function annotateCommands(actions: Actions): Command[] {
  return [...lineCommands(actions), ...spaceCommands(actions)];
}

function lineCommands(actions: Actions): Command[] {
  const { store } = actions.state;
  const some = () => store.selection.value.size > 0;
  const chosen = () => store.sketch.value.lines.filter((_, i) => store.selection.value.has(i));
  const allExact = () => some() && chosen().every((line) => line.exact === true);
  return [
    {
      id: 'exact',
      label: text.commands.exact,
      group: 'annotate',
      icon: 'exact',
      shortcut: 'E',
      when: some,
      checked: allExact,
      run: () =>
        actions.edit(
          text.edits.exact,
          setExact(store.sketch.value, store.selection.value, !allExact()),
        ),
    },
    ...HOLE_AXES.map(
      ([id, axis, label]): Command => ({
        id,
        label,
        group: 'annotate',
        icon: 'axis',
        when: some,
        checked: () => some() && chosen().every((line) => (line.holeAxis ?? null) === axis),
        run: () =>
          actions.edit(
            text.edits.holeAxis,
            setHoleAxis(store.sketch.value, store.selection.value, axis),
          ),
      }),
    ),
  ];
}

function spaceCommands(actions: Actions): Command[] {
  const { store } = actions.state;
  const has = (key: 'keepOut' | 'joints' | 'shafts') => () =>
    (store.sketch.value[key]?.length ?? 0) > 0;
  const row = { group: 'annotate', icon: 'keepOut' } as const;
  return [
    {
      ...row,
      id: 'groundHere',
      label: text.commands.groundHere,
      icon: 'plane',
      when: () => store.sketch.value.lines.length > 0,
      run: () => {
        const sketch = store.sketch.value;
        // Half a module of beam lies below the lowest line.
        const ground = (sketchBounds(sketch)?.min[2] ?? 0) - 1;
        actions.edit(text.edits.ground, setGround(sketch, ground));
      },
    },
    {
      ...row,
      id: 'groundNone',
      label: text.commands.groundNone,
      icon: 'plane',
      when: () => store.sketch.value.ground !== undefined,
      run: () => actions.edit(text.edits.ground, setGround(store.sketch.value, null)),
    },
    {
      ...row,
      id: 'clearKeepOut',
      label: text.commands.clearKeepOut,
      when: has('keepOut'),
      run: () => actions.edit(text.edits.keepOut, without(store.sketch.value, 'keepOut')),
    },
    {
      ...row,
      id: 'clearJoints',
      label: text.commands.clearJoints,
      icon: 'joint',
      when: has('joints'),
      run: () => actions.edit(text.edits.joint, without(store.sketch.value, 'joints')),
    },
    {
      ...row,
      id: 'crankOnShaft',
      label: text.commands.crankOnShaft,
      icon: 'shaft',
      when: has('shafts'),
      run: () => actions.edit(text.edits.shaft, withEnds(store.sketch.value, { atFrom: 'crank' })),
    },
    {
      ...row,
      id: 'wheelsOnShaft',
      label: text.commands.wheelsOnShaft,
      icon: 'shaft',
      when: has('shafts'),
      run: () =>
        actions.edit(
          text.edits.shaft,
          withEnds(store.sketch.value, { atFrom: 'wheel', atTo: 'wheel' }),
        ),
    },
    {
      ...row,
      id: 'clearShafts',
      label: text.commands.clearShafts,
      icon: 'shaft',
      when: has('shafts'),
      run: () => actions.edit(text.edits.shaft, clearShafts(store.sketch.value)),
    },
  ];
}

function without(sketch: SketchDocument, key: 'keepOut' | 'joints'): SketchDocument {
  const { [key]: _dropped, ...rest } = sketch;
  return rest;
}
