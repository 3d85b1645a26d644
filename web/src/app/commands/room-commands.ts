import type { Command } from '../../ui/command.ts';
import type { IconName } from '../../ui/icon.tsx';
import { ROOM_TITLES } from '../../ui/rooms/take-away-rooms.ts';
import type { Actions } from '../actions.ts';

const ROWS: readonly (readonly [keyof typeof ROOM_TITLES, IconName, string | undefined])[] = [
  ['instructions', 'parts', 'Mod+I'],
  ['share', 'download', 'Mod+Shift+S'],
  ['gallery', 'gallery', undefined],
  ['lessons', 'help', undefined],
];

/** Opens the rooms for building, sharing and learning. */
export function roomCommands(actions: Actions): Command[] {
  return ROWS.map(([id, icon, shortcut]) => ({
    id: `room-${id}`,
    label: ROOM_TITLES[id],
    group: 'file',
    icon,
    ...(shortcut ? { shortcut } : {}),
    run: () => actions.openRoom(id),
  }));
}
