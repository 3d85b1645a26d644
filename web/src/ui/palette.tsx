import { useState } from 'preact/hooks';
import type { Command } from './command.ts';
import { Keys } from './controls.tsx';
import { Dialog } from './dialog.tsx';
import { Icon } from './icon.tsx';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

/**
 * Commands that fit a search, best first: every word of it must occur; words that begin with it win.
 */
export function searchCommands(commands: readonly Command[], query: string): Command[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  return commands
    .map((command, order) => ({ command, order, rank: rankOf(command, words) }))
    .filter(({ rank }) => rank >= 0)
    .sort((a, b) => b.rank - a.rank || a.order - b.order)
    .map(({ command }) => command);
}

function rankOf(command: Command, words: readonly string[]): number {
  const label = `${command.label} ${text.groups[command.group]}`.toLowerCase();
  let rank = 0;
  for (const word of words) {
    const at = label.indexOf(word);
    if (at < 0) {
      return -1;
    }
    rank += at === 0 ? 3 : label[at - 1] === ' ' ? 2 : 1;
  }
  return rank;
}

/** All commands to search and to run: by typing, arrow keys and Enter, or by a click. */
export function Palette() {
  const { commands, dialog } = usePage();
  const [query, setQuery] = useState('');
  const [chosen, setChosen] = useState(0);
  const found = searchCommands(commands.all, query).filter(
    (command) => !command.when || command.when(),
  );
  const active = Math.min(chosen, found.length - 1);
  const run = (command: Command | undefined) => {
    if (command) {
      dialog.value = null;
      command.run();
    }
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key === 'ArrowDown' || event.key === 'ArrowUp') {
      event.preventDefault();
      const step = event.key === 'ArrowDown' ? 1 : -1;
      setChosen((active + step + found.length) % Math.max(1, found.length));
    } else if (event.key === 'Enter') {
      event.preventDefault();
      run(found[active]);
    }
  };
  return (
    <Dialog title={text.palette.title} class="palette">
      <input
        class="palette-input"
        role="combobox"
        aria-expanded="true"
        aria-controls="palette-list"
        aria-activedescendant={found[active] ? `command-${found[active].id}` : undefined}
        aria-label={text.palette.placeholder}
        placeholder={text.palette.placeholder}
        autocomplete="off"
        autofocus
        value={query}
        onInput={(event) => {
          setQuery(event.currentTarget.value);
          setChosen(0);
        }}
        onKeyDown={onKeyDown}
      />
      <div class="palette-list" id="palette-list" role="listbox" aria-label={text.palette.title}>
        {found.map((command, i) => (
          <PaletteRow
            key={command.id}
            command={command}
            active={i === active}
            onPick={() => run(command)}
          />
        ))}
      </div>
      {found.length === 0 ? <p class="quiet">{text.palette.none}</p> : null}
    </Dialog>
  );
}

function PaletteRow(props: {
  readonly command: Command;
  readonly active: boolean;
  readonly onPick: () => void;
}) {
  const { command } = props;
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: the keys are taken by the combobox
    <div
      id={`command-${command.id}`}
      role="option"
      tabIndex={-1}
      aria-selected={props.active}
      ref={(element) => {
        if (props.active) {
          element?.scrollIntoView({ block: 'nearest' });
        }
      }}
      onClick={props.onPick}
    >
      <Icon name={command.checked?.() ? 'check' : command.icon} />
      <span class="palette-label">{command.label}</span>
      <span class="quiet">{text.groups[command.group]}</span>
      {command.shortcut ? <Keys shortcut={command.shortcut} /> : <span />}
    </div>
  );
}
