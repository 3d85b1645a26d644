import type { Command } from '../../ui/command.ts';
import type { IconName } from '../../ui/icon.tsx';
import { nameOfPlace } from '../../ui/places.ts';
import { ROOM_TITLES } from '../../ui/rooms/take-away-rooms.ts';
import { text } from '../../ui/text.ts';
import type { Actions } from '../actions.ts';

const ROWS: readonly (readonly [keyof typeof ROOM_TITLES, IconName, string | undefined])[] = [
  ['instructions', 'steps', 'Mod+I'],
  ['share', 'send', 'Mod+Shift+S'],
  ['gallery', 'gallery', undefined],
  ['lessons', 'book', undefined],
  ['laboratory', 'flask', undefined],
  ['linkage', 'turn', undefined],
];

const BESIDE: readonly (readonly ['draw' | 'check' | 'move', IconName, string])[] = [
  ['draw', 'pencil', text.commands.placeDraw],
  ['check', 'shield', text.commands.placeCheck],
  ['move', 'turn', text.commands.placeMove],
];

/** Opens the rooms for building, sharing and learning, and the places beside the drawing. */
export function roomCommands(actions: Actions): Command[] {
  const beside = BESIDE.map(
    ([id, icon, label]): Command => ({
      id: `place-${id}`,
      label,
      group: 'view',
      icon,
      run: () => actions.openRoom(nameOfPlace(id)),
    }),
  );
  return [...beside, ...rooms(actions)];
}

function rooms(actions: Actions): Command[] {
  return ROWS.map(([id, icon, shortcut]) => ({
    id: `room-${id}`,
    label: ROOM_TITLES[id],
    group: 'file',
    icon,
    ...(shortcut ? { shortcut } : {}),
    run: () => actions.openRoom(id),
  }));
}
