import { expect, it } from 'vitest';
import { isLookedAtPlace, nameOfPlace, PLACES, placeOf } from '../../../web/src/ui/places.ts';
import { ROOMS } from '../../../web/src/ui/rooms/room-table.ts';

it('every place is found again by its name in the address', () => {
  for (const { id } of PLACES) {
    expect(placeOf(nameOfPlace(id))).toBe(id);
  }
});

it('a name that is none is the drawing', () => {
  expect(placeOf('nowhere')).toBe('draw');
});

it('every room has its place, but for what is opened from one', () => {
  const rooms = PLACES.filter(({ id }) => id !== 'draw' && !isLookedAtPlace(id));
  expect([...rooms.map(({ id }) => id), 'linkage']).toEqual(ROOMS.map(({ id }) => id));
});
