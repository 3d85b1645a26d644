import type { Command } from './command.ts';
import { Keys } from './controls.tsx';
import { Dialog } from './dialog.tsx';
import { Icon } from './icon.tsx';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

/** What a person begins with: large, with a picture each. */
const START = ['new', 'open', 'sketches', 'examples'] as const;

/** Everything else that has no button of its own in sight, in groups. All of it is in the palette too. */
const GROUPS: readonly (readonly [keyof typeof text.menu, readonly string[]])[] = [
  ['keep', ['saveSketch', 'savePicture', 'share', 'room-share']],
  ['change', ['selectAll', 'duplicate', 'delete', 'bricks', 'newSeed', 'autoSolve']],
  ['look', ['themeAuto', 'themeLight', 'themeDark', 'projection', 'languageEn', 'languageDe']],
  ['help', ['palette', 'help', 'guide', 'about']],
];

/** The menu: groups with pictures, for those who look and do not type. */
export function Menu() {
  const { commands } = usePage();
  return (
    <Dialog title={text.menu.title} class="menu">
      <ul class="menu-tiles" aria-label={text.menu.start}>
        {START.map((id) => (
          <li key={id}>
            <MenuEntry command={commands.get(id)} class="menu-tile" />
          </li>
        ))}
      </ul>
      <div class="menu-groups">
        {GROUPS.map(([name, ids]) => (
          <section key={name}>
            <h3>{text.menu[name]}</h3>
            <ul>
              {ids.map((id) => (
                <li key={id}>
                  <MenuEntry command={commands.get(id)} class="menu-entry" />
                </li>
              ))}
            </ul>
          </section>
        ))}
      </div>
    </Dialog>
  );
}

function MenuEntry(props: { readonly command: Command; readonly class: string }) {
  const { dialog } = usePage();
  const { command } = props;
  return (
    <button
      type="button"
      class={props.class}
      aria-pressed={command.checked?.()}
      disabled={command.when ? !command.when() : false}
      onClick={() => {
        dialog.value = null;
        command.run();
      }}
    >
      <Icon name={command.checked?.() ? 'check' : command.icon} />
      <span>{command.label}</span>
      {command.shortcut ? <Keys shortcut={command.shortcut} /> : null}
    </button>
  );
}
