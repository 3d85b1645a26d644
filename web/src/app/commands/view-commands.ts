import type { Preferences } from '../../state/preferences.ts';
import type { Command } from '../../ui/command.ts';
import type { IconName } from '../../ui/icon.tsx';
import type { DialogName } from '../../ui/page.ts';
import { text } from '../../ui/text.ts';
import type { StandardView } from '../../view/view-types.ts';
import type { Actions } from '../actions.ts';

const VIEWS: readonly (readonly [string, StandardView, IconName, string, string | undefined])[] = [
  ['viewIso', 'iso', 'cube', text.commands.viewIso, 'I'],
  ['viewFront', 'front', 'viewFront', text.commands.viewFront, undefined],
  ['viewRight', 'right', 'viewRight', text.commands.viewRight, undefined],
  ['viewTop', 'top', 'viewTop', text.commands.viewTop, 'T'],
  ['viewBack', 'back', 'cube', text.commands.viewBack, undefined],
  ['viewLeft', 'left', 'cube', text.commands.viewLeft, undefined],
  ['viewBottom', 'bottom', 'cube', text.commands.viewBottom, undefined],
];

const TURN = Math.PI / 12;

/** Nearer and farther by a factor, and turns to the right and upwards by radians. */
const MOVES: readonly (readonly [string, IconName, string, string, number, number, number])[] = [
  ['zoomIn', 'plus', text.commands.zoomIn, 'Plus', 0.8, 0, 0],
  ['zoomOut', 'minus', text.commands.zoomOut, '-', 1.25, 0, 0],
  ['turnLeft', 'rotate', text.commands.turnLeft, 'Alt+ArrowLeft', 1, -TURN, 0],
  ['turnRight', 'rotate', text.commands.turnRight, 'Alt+ArrowRight', 1, TURN, 0],
  ['turnUp', 'rotate', text.commands.turnUp, 'Alt+ArrowUp', 1, 0, TURN],
  ['turnDown', 'rotate', text.commands.turnDown, 'Alt+ArrowDown', 1, 0, -TURN],
];

const SHOWS: readonly (readonly [string, Preferences['show'], string])[] = [
  ['showSketch', 'sketch', text.commands.showSketch],
  ['showBoth', 'both', text.commands.showBoth],
  ['showModel', 'model', text.commands.showModel],
];

const COLOURS: readonly (readonly [string, Preferences['colourBy'], string])[] = [
  ['colourPart', 'part', text.commands.colourPart],
  ['colourLayer', 'layer', text.commands.colourLayer],
  ['colourAxis', 'axis', text.commands.colourAxis],
  ['colourComponent', 'component', text.commands.colourComponent],
  ['colourPiece', 'piece', text.commands.colourPiece],
];

const THEMES: readonly (readonly [string, Preferences['theme'], string])[] = [
  ['themeAuto', 'auto', text.commands.themeAuto],
  ['themeLight', 'light', text.commands.themeLight],
  ['themeDark', 'dark', text.commands.themeDark],
];

const LANGUAGES: readonly (readonly [string, Preferences['language'], string])[] = [
  ['languageAuto', 'auto', text.commands.languageAuto],
  ['languageEn', 'en', text.commands.languageEn],
  ['languageDe', 'de', text.commands.languageDe],
];

const DIALOGS: readonly (readonly [
  NonNullable<DialogName>,
  IconName,
  string,
  string | undefined,
])[] = [
  ['menu', 'menu', text.commands.menu, undefined],
  ['palette', 'search', text.commands.palette, 'Mod+K'],
  ['help', 'help', text.commands.help, '?'],
  ['about', 'info', text.commands.about, undefined],
];

/** Camera, colours, theme and the sheets. */
export function viewCommands(actions: Actions): Command[] {
  return [
    ...cameraCommands(actions),
    dimensions(actions),
    ...choices(actions, 'show', 'palette', SHOWS),
    ...choices(actions, 'colourBy', 'palette', COLOURS),
    ...choices(actions, 'theme', 'theme', THEMES),
    themeNext(actions),
    guide(actions),
    ...choices(actions, 'language', 'language', LANGUAGES),
    ...DIALOGS.map(
      ([id, icon, label, shortcut]): Command => ({
        id,
        label,
        group: 'help',
        icon,
        ...(shortcut ? { shortcut } : {}),
        run: () => {
          actions.state.dialog.value = id;
        },
      }),
    ),
  ];
}

function cameraCommands(actions: Actions): Command[] {
  const { preferences } = actions.state;
  return [
    {
      id: 'fit',
      label: text.commands.fit,
      group: 'view',
      icon: 'fit',
      shortcut: 'F',
      run: actions.fit,
    },
    ...MOVES.map(
      ([id, icon, label, shortcut, factor, right, up]): Command => ({
        id,
        label,
        group: 'view',
        icon,
        shortcut,
        run: () => actions.moveCamera({ factor, right, up }),
      }),
    ),
    ...VIEWS.map(
      ([id, view, icon, label, shortcut]): Command => ({
        id,
        label,
        group: 'view',
        icon,
        ...(shortcut ? { shortcut } : {}),
        run: () => actions.setView(view),
      }),
    ),
    {
      id: 'projection',
      label: text.commands.projection,
      group: 'view',
      icon: 'perspective',
      shortcut: 'O',
      checked: () => preferences.value.projection === 'perspective',
      run: () => {
        const now = preferences.value.projection;
        const projection = now === 'perspective' ? 'orthographic' : 'perspective';
        preferences.value = { ...preferences.value, projection };
      },
    },
  ];
}

/** From light to dark and back. */
function themeNext({ state }: Actions): Command {
  return {
    id: 'themeNext',
    label: text.commands.themeNext,
    group: 'view',
    icon: 'theme',
    run: () => {
      const theme = state.themeName.value === 'dark' ? 'light' : 'dark';
      state.preferences.value = { ...state.preferences.value, theme };
    },
  };
}

/** Lengths beside all lines; those of selected ones are there anyway. */
function dimensions({ state: { preferences } }: Actions): Command {
  return {
    id: 'dimensions',
    label: text.commands.dimensions,
    group: 'view',
    icon: 'measure',
    shortcut: 'Shift+L',
    checked: () => preferences.value.dimensions,
    run: () => {
      preferences.value = { ...preferences.value, dimensions: !preferences.value.dimensions };
    },
  };
}

/** The first task in steps: on for a newcomer, and for whoever wants it again. */
function guide({ state: { preferences } }: Actions): Command {
  return {
    id: 'guide',
    label: text.commands.guide,
    group: 'help',
    icon: 'info',
    checked: () => preferences.value.guide,
    run: () => {
      preferences.value = { ...preferences.value, guide: !preferences.value.guide };
    },
  };
}

/** One command for each value that a preference can have. */
function choices<K extends 'show' | 'colourBy' | 'theme' | 'language'>(
  { state: { preferences } }: Actions,
  key: K,
  icon: IconName,
  rows: readonly (readonly [string, Preferences[K], string])[],
): Command[] {
  return rows.map(
    ([id, value, label]): Command => ({
      id,
      label,
      group: 'view',
      icon,
      checked: () => preferences.value[key] === value,
      run: () => {
        preferences.value = { ...preferences.value, [key]: value };
      },
    }),
  );
}
