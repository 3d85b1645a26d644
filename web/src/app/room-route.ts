import { effect, type Signal } from '@preact/signals';

const KEY = 'room';

/** The room that an address names, or null. */
export function roomInAddress(search: string): string | null {
  return new URLSearchParams(search).get(KEY);
}

/** An address with another room (null: none); sketch and everything else in it stay. */
export function addressWithRoom(address: string, room: string | null): string {
  const url = new URL(address);
  if (room === null) {
    url.searchParams.delete(KEY);
  } else {
    url.searchParams.set(KEY, room);
  }
  return url.href;
}

/** Keeps the room and `?room=` in the address the same, so that the browser's back button leaves it. */
export function followRoom(room: Signal<string | null>): () => void {
  room.value = roomInAddress(location.search);
  const back = () => {
    room.value = roomInAddress(location.search);
  };
  window.addEventListener('popstate', back);
  const stop = effect(() => {
    if (room.value !== roomInAddress(location.search)) {
      history.pushState(history.state, '', addressWithRoom(location.href, room.value));
    }
  });
  return () => {
    stop();
    window.removeEventListener('popstate', back);
  };
}
