import { CommandButton, IconButton } from './controls.tsx';
import { Icon } from './icon.tsx';
import { usePage } from './page-context.ts';
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

/** Name, files, undo, search, sharing and theme. */
export function TopBar() {
  const page = usePage();
  const { store, dialog, mac } = page;
  return (
    <header class="top-bar">
      <h1 class="brand">
        <Mark />
        <span>{text.app.name}</span>
      </h1>
      <span class="divider wide-only" />
      <CommandButton id="examples" words={text.examples.title} class="wide-only plain" />
      <CommandButton id="sketches" class="wide-only" />
      <CommandButton id="open" class="wide-only" />
      <CommandButton id="new" class="wide-only" />
      <span class="divider wide-only" />
      <CommandButton id="undo" />
      <CommandButton id="redo" />
      <input
        class="name-field"
        aria-label={text.app.sketchName}
        placeholder={text.app.untitled}
        value={store.sketch.value.name ?? ''}
        maxLength={120}
        spellcheck={false}
        onChange={(event) => page.rename(event.currentTarget.value)}
      />
      <button
        type="button"
        class="search-button wide-only"
        onClick={() => {
          dialog.value = 'palette';
        }}
      >
        <Icon name="search" />
        <span>{text.palette.placeholder}</span>
        <kbd>{mac ? '⌘K' : 'Ctrl K'}</kbd>
      </button>
      <CommandButton id="share" class="wide-only" />
      <CommandButton id="help" class="wide-only" />
      <ThemeButton />
      <IconButton
        icon="menu"
        label={text.app.menu}
        class="narrow-only"
        onClick={() => {
          dialog.value = 'palette';
        }}
      />
    </header>
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
