import type { IconName } from './icon.tsx';

/** The places of the page. Those after `move` are rooms: they cover the drawing (rooms/room-table.ts). */
export type PlaceId =
  | 'draw'
  | 'check'
  | 'move'
  | 'instructions'
  | 'share'
  | 'gallery'
  | 'lessons'
  | 'laboratory';

export interface Place {
  readonly id: PlaceId;
  readonly icon: IconName;
}

/** In the order of the work; what is for looking around comes last. */
export const PLACES: readonly Place[] = [
  { id: 'draw', icon: 'pencil' },
  { id: 'check', icon: 'shield' },
  { id: 'move', icon: 'turn' },
  { id: 'instructions', icon: 'steps' },
  { id: 'share', icon: 'send' },
  { id: 'gallery', icon: 'gallery' },
  { id: 'lessons', icon: 'book' },
  { id: 'laboratory', icon: 'flask' },
];

/** The place that a name in the address stands for; drawing is what no other name is. */
export function placeOf(name: string | null): PlaceId {
  return PLACES.find(({ id }) => id === name)?.id ?? 'draw';
}

/** The name in the address for a place: none for the drawing. */
export function nameOfPlace(id: PlaceId): string | null {
  return id === 'draw' ? null : id;
}

/** Whether the place is the drawing with another panel beside it, and not the drawing itself. */
export function isLookedAtPlace(name: string | null): boolean {
  const place = placeOf(name);
  return place === 'check' || place === 'move';
}
