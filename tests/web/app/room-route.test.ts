import { expect, test } from 'vitest';
import { addressWithRoom, roomInAddress } from '../../../web/src/app/room-route.ts';

const SHARED = 'https://example.org/page/?lang=de#s1.abc.def';

test('a room in the address leaves the shared sketch and the language in it', () => {
  const address = addressWithRoom(SHARED, 'instructions');
  expect(address).toBe('https://example.org/page/?lang=de&room=instructions#s1.abc.def');
  expect(roomInAddress(new URL(address).search)).toBe('instructions');
});

test('leaving the room gives the address back as it was', () => {
  expect(addressWithRoom(addressWithRoom(SHARED, 'gallery'), null)).toBe(SHARED);
});
