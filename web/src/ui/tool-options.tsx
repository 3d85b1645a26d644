import { useRef } from 'preact/hooks';
import type { PlaneMode } from '../tools/tool.ts';
import { CommandButton, Segmented } from './controls.tsx';
import { DriveField } from './drive-field.tsx';
import { useOverflowCue } from './overflow-cue.ts';
import { usePage } from './page-context.ts';
import { ShaftEndsField } from './shaft-ends-field.tsx';
import { text } from './text.ts';

const PLANES: readonly { value: PlaneMode; label: string; command: string }[] = [
  { value: 'auto', label: text.draw.auto, command: 'planeAuto' },
  { value: 'z', label: text.draw.planeXY, command: 'planeXY' },
  { value: 'x', label: text.draw.planeYZ, command: 'planeYZ' },
  { value: 'y', label: text.draw.planeZX, command: 'planeZX' },
];

const SELECTION_COMMANDS = [
  'offset',
  'duplicate',
  'tool.array',
  'mirrorX',
  'rotateZ',
  'join',
  'exact',
] as const;

/** These three differ by their letter alone. */
const HOLE_AXES = [
  ['holeAxisX', 'X'],
  ['holeAxisY', 'Y'],
  ['holeAxisZ', 'Z'],
] as const;

/** How sizes are typed, by how many there are. */
const SIZES_LIKE: Readonly<Record<number, string>> = { 2: '6,8', 3: '6,8,4' };

/** What goes with the tool in use: the plane and the length, or what can be done to the selection. */
export function ToolOptions() {
  const page = usePage();
  const tool = page.tool.value;
  const drawing =
    tool.id !== 'select' && tool.id !== 'split' && tool.id !== 'joint' && tool.id !== 'measure';
  const selected = page.store.selection.value.size;
  if (drawing) {
    return (
      <div class="tool-options floating">
        <PlaneChoice />
        <SizeField />
        {tool.id === 'shaft' && <DriveField />}
        {tool.id === 'shaft' && <ShaftEndsField />}
      </div>
    );
  }
  return tool.id === 'select' && selected > 0 ? <SelectionOptions selected={selected} /> : null;
}

function SelectionOptions({ selected }: { readonly selected: number }) {
  const row = useRef<HTMLDivElement>(null);
  useOverflowCue(row);
  return (
    <div ref={row} class="tool-options floating" role="toolbar" aria-label={text.groups.edit}>
      <span class="selection-count">{selected}</span>
      {SELECTION_COMMANDS.map((id) => (
        <CommandButton key={id} id={id} />
      ))}
      {HOLE_AXES.map(([id, letter]) => (
        <CommandButton key={id} id={id} words={letter} named={true} class="plain axis-button" />
      ))}
      <CommandButton id="delete" />
    </div>
  );
}

function PlaneChoice() {
  const { commands } = usePage();
  const now = PLANES.find((plane) => commands.get(plane.command).checked?.());
  return (
    <Segmented
      name="plane"
      legend={text.draw.plane}
      choices={PLANES}
      value={now?.value ?? 'auto'}
      onChange={(value) => {
        const plane = PLANES.find((each) => each.value === value);
        if (plane) {
          commands.run(plane.command);
        }
      }}
    />
  );
}

/** The size typed so far; the drawing keeps the keys, and gets them back after Enter. */
function SizeField() {
  const page = usePage();
  const { typed, preview, label, sizes } = page.tool.value.overlay.value;
  const several = sizes > 1;
  return (
    <label class="length-field">
      <span>{several ? text.draw.size : text.draw.length}</span>
      <input
        inputMode={several ? 'decimal' : 'numeric'}
        autocomplete="off"
        value={typed}
        placeholder={label?.main ?? (several ? SIZES_LIKE[sizes] : '–')}
        disabled={!preview && !several}
        onInput={(event) => page.typeLength(event.currentTarget.value)}
        onKeyDown={(event) => {
          if (event.key === 'Enter') {
            page.tool.value.key({ key: 'Enter', shift: false });
            page.focusDrawing();
          }
        }}
      />
    </label>
  );
}
