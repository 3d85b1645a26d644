import type { TextStorage } from '../state/preferences.ts';

/** Another site that shows the page in a frame must not change what the person has kept here. */
export function isForeignFrame(): boolean {
  try {
    return window.top !== window && window.top?.location.origin !== location.origin;
  } catch {
    return true;
  }
}

/** The storage for texts, or null where there is none. */
export function textStorage(kind: 'localStorage' | 'sessionStorage'): TextStorage | null {
  try {
    return isForeignFrame() ? null : window[kind];
  } catch {
    return null;
  }
}
