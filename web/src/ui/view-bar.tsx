import type { Preferences } from '../state/preferences.ts';
import { CommandButton, Keys, Segmented } from './controls.tsx';
import { Flyout } from './flyout.tsx';
import { Icon } from './icon.tsx';
import { LookInside } from './look-inside.tsx';
import { usePage } from './page-context.ts';
import { text } from './text.ts';
import { ColourChoice, ExplodeSlider } from './view-controls.tsx';

const SHOW: readonly { value: Preferences['show']; label: string }[] = [
  { value: 'sketch', label: text.view.sketch },
  { value: 'both', label: text.view.both },
  { value: 'model', label: text.view.model },
];

const VIEWS = [
  'viewIso',
  'viewTop',
  'viewFront',
  'viewRight',
  'viewBack',
  'viewLeft',
  'viewBottom',
  'projection',
  'dimensions',
] as const;

/** How the scene is looked at. */
export function ViewBar() {
  const { preferences } = usePage();
  return (
    <div class="view-bar floating" role="toolbar" aria-label={text.view.title}>
      <Segmented
        name="show"
        legend={text.view.show}
        choices={SHOW}
        value={preferences.value.show}
        onChange={(value) => {
          preferences.value = { ...preferences.peek(), show: value };
        }}
      />
      <ExplodeSlider class="wide-only" />
      <ColourChoice class="wide-only" />
      <span class="divider wide-only" />
      <LookInside />
      <Flyout icon="cube" label={text.view.views} rows={true}>
        {VIEWS.map((id) => (
          <ViewRow key={id} id={id} />
        ))}
      </Flyout>
      <CommandButton id="fit" />
    </div>
  );
}

function ViewRow({ id }: { readonly id: string }) {
  const command = usePage().commands.get(id);
  return (
    <button type="button" class="menu-row" aria-pressed={command.checked?.()} onClick={command.run}>
      <Icon name={command.checked?.() ? 'check' : command.icon} />
      <span>{command.label}</span>
      {command.shortcut ? <Keys shortcut={command.shortcut} /> : null}
    </button>
  );
}
