import { effect } from '@preact/signals';
import type { PagePreferences } from '../state/page-preferences.ts';

/**
 * Loads the page again when another language is chosen: words are chosen once a load.
 * @param kept settles when the sketch is written, so that the reload loses nothing.
 */
export function followLanguage(
  preferences: PagePreferences,
  kept: () => Promise<void>,
): () => void {
  const first = preferences.peek().language;
  return effect(() => {
    if (preferences.value.language !== first) {
      kept().then(reload, reload);
    }
  });
}

function reload(): void {
  const address = new URL(location.href);
  if (address.searchParams.has('lang')) {
    // What was asked for in the address would win over what was just chosen.
    address.searchParams.delete('lang');
    history.replaceState(history.state, '', address);
  }
  location.reload();
}
