import type { Room } from './room.ts';
import { TAKE_AWAY_ROOMS } from './take-away-rooms.ts';

/** All rooms; a new one is a row here. Each needs a command that opens it (`actions.openRoom`). */
export const ROOMS: readonly Room[] = [...TAKE_AWAY_ROOMS];

/** The room with this id, or null: the drawing. */
export function findRoom(id: string | null): Room | null {
  return ROOMS.find((room) => room.id === id) ?? null;
}
