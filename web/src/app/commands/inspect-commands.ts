import type { AxisName } from '../../geometry/vec.ts';
import { fillWords } from '../../tools/tool-words.ts';
import type { Command } from '../../ui/command.ts';
import { text } from '../../ui/text.ts';
import type { Actions } from '../actions.ts';

const CUTS: readonly (readonly [string, AxisName, string])[] = [
  ['cutX', 'x', text.commands.cutX],
  ['cutY', 'y', text.commands.cutY],
  ['cutZ', 'z', text.commands.cutZ],
];

const STEPS: readonly (readonly [string, number, string, string])[] = [
  ['partNext', 1, text.commands.partNext, 'N'],
  ['partPrevious', -1, text.commands.partPrevious, 'Shift+N'],
];

/** How far a neighbour's middle may be from the picked part's, modules: what touches it is within. */
const NEAR = 1.6;

/** Cuts and isolation. */
export function inspectCommands(actions: Actions): Command[] {
  const { state } = actions;
  const model = () => state.shown.value !== null;
  return [
    ...STEPS.map(
      ([id, step, label, shortcut]): Command => ({
        id,
        label,
        group: 'view',
        icon: 'select',
        shortcut,
        when: model,
        run: () => pickBeside(actions, step),
      }),
    ),
    ...isolateCommands(actions),
    ...CUTS.map(
      ([id, axis, label]): Command => ({
        id,
        label,
        group: 'view',
        icon: 'cut',
        when: model,
        checked: () => state.section.value?.axis === axis,
        run: () => actions.cutAlong(state.section.value?.axis === axis ? null : axis),
      }),
    ),
  ];
}

/** Picks the part after or before the picked one, round and round, and says which it is. */
function pickBeside({ state, announce }: Actions, step: number): void {
  const parts = state.shown.value?.model.parts ?? [];
  const now = state.pickedPart.value ?? (step > 0 ? -1 : 0);
  const index = (now + step + parts.length) % Math.max(1, parts.length);
  const id = parts[index]?.part;
  if (id !== undefined) {
    state.pickedPart.value = index;
    const name = state.result.value?.rows.find((row) => row.part === id)?.name ?? id;
    announce(fillWords(text.part.picked, { i: index + 1, all: parts.length, name }));
  }
}

function isolateCommands(actions: Actions): Command[] {
  const { state } = actions;
  const picked = () => state.pickedPart.value !== null;
  const row = { group: 'view', icon: 'isolate' } as const;
  const show = (wanted: (index: number) => boolean) => {
    const parts = state.shown.value?.model.parts ?? [];
    state.isolation.value = {
      parts: new Set([...parts.keys()].filter(wanted)),
      others: 'ghost',
    };
  };
  const pickedPart = () => state.shown.value?.model.parts[state.pickedPart.value ?? -1];
  return [
    {
      ...row,
      id: 'isolateSame',
      label: text.commands.isolateSame,
      when: picked,
      run: () => {
        const parts = state.shown.value?.model.parts ?? [];
        const wanted = pickedPart()?.part;
        show((index) => parts[index]?.part === wanted);
      },
    },
    {
      ...row,
      id: 'isolatePiece',
      label: text.commands.isolateNear,
      when: picked,
      run: () => {
        const near = partsNear(state, state.pickedPart.value ?? -1);
        show((index) => near.has(index));
      },
    },
    {
      ...row,
      id: 'isolateNone',
      label: text.commands.isolateNone,
      when: () => state.isolation.value !== null,
      run: () => {
        state.isolation.value = null;
      },
    },
  ];
}

/** The part and all whose holes or heads lie near one of its own: what it is joined to. */
function partsNear({ shown, catalogue }: Actions['state'], index: number): ReadonlySet<number> {
  const parts = shown.value?.model.parts ?? [];
  const slots = parts.map((placed) => {
    const features = catalogue.find(placed.part)?.features ?? [];
    return features.flatMap((feature) =>
      feature.slots.map(([x, y, z]) => {
        const r = placed.rotation;
        const p = placed.position;
        return [
          p[0] + r[0] * x + r[1] * y + r[2] * z,
          p[1] + r[3] * x + r[4] * y + r[5] * z,
          p[2] + r[6] * x + r[7] * y + r[8] * z,
        ] as const;
      }),
    );
  });
  const own = slots[index] ?? [];
  const touches = (other: (typeof own)[number]) =>
    own.some((a) => Math.hypot(a[0] - other[0], a[1] - other[1], a[2] - other[2]) < NEAR / 2);
  return new Set(slots.flatMap((places, i) => (i === index || places.some(touches) ? [i] : [])));
}
