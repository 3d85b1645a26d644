import { CommandButton, IconButton } from './controls.tsx';
import { Icon } from './icon.tsx';
import { usePage } from './page-context.ts';
import { findRoom } from './rooms/room-table.ts';
import { Spine } from './spine.tsx';
import { text } from './text.ts';

/** Three holes of a beam: the mark of the program. */
function Mark() {
  return (
    <svg class="mark" viewBox="0 0 44 16" aria-hidden="true">
      <rect x="0.75" y="0.75" width="42.5" height="14.5" rx="7.25" />
      <circle cx="8" cy="8" r="3.6" />
      <circle cx="22" cy="8" r="3.6" />
      <circle cx="36" cy="8" r="3.6" />
    </svg>
  );
}

/** Menu, name, the places, undo, search, help and theme. It stays when a room is open. */
export function TopBar() {
  const page = usePage();
  const { store, room } = page;
  const drawing = findRoom(room.value) === null;
  return (
    <header class={drawing ? 'top-bar' : 'top-bar in-room'}>
      <h1 class="brand">
        <Mark />
        <span>{text.app.name}</span>
      </h1>
      <MenuButton />
      <CommandButton id="new" class="wide-only" />
      <input
        class="name-field"
        aria-label={text.app.sketchName}
        placeholder={text.app.untitled}
        value={store.sketch.value.name ?? ''}
        maxLength={120}
        spellcheck={false}
        onChange={(event) => page.rename(event.currentTarget.value)}
      />
      <Spine />
      <div class="bar-end">
        <CommandButton id="undo" class={drawing ? '' : 'away'} />
        <CommandButton id="redo" class={drawing ? '' : 'away'} />
        <CommandButton id="palette" class="wide-only" />
        <CommandButton id="help" class="wide-only" />
        <ThemeButton />
      </div>
    </header>
  );
}

function MenuButton() {
  const { dialog } = usePage();
  return (
    <button
      type="button"
      class="button plain menu-button"
      aria-label={text.app.menu}
      onClick={() => {
        dialog.value = 'menu';
      }}
    >
      <Icon name="menu" />
      <span>{text.app.menu}</span>
    </button>
  );
}

function ThemeButton() {
  const { commands, preferences } = usePage();
  const { theme } = preferences.value;
  const next = { auto: 'light', light: 'dark', dark: 'auto' } as const;
  const id = { auto: 'themeAuto', light: 'themeLight', dark: 'themeDark' } as const;
  return (
    <IconButton
      icon="theme"
      label={commands.get(id[theme]).label}
      class="wide-only"
      onClick={() => commands.run(id[next[theme]])}
    />
  );
}
