import { batch, computed, type ReadonlySignal, type Signal } from '@preact/signals';
import type { Preferences } from './preferences.ts';
import { SEARCH_KEYS, type SearchSettings, searchSettingsOf } from './search-settings.ts';

/** What the page reads and sets; as a signal. */
export interface PagePreferences {
  value: Preferences;
  peek(): Preferences;
}

/**
 * What is in force on the page: a sketch that brought settings of its own, by a link, is searched with them, and what
 * is changed of them stays with it; everything else is the person's.
 */
export function pagePreferences(
  own: Signal<Preferences>,
  ofSketch: Signal<SearchSettings | null>,
): PagePreferences {
  const shown: ReadonlySignal<Preferences> = computed(() => ({ ...own.value, ...ofSketch.value }));
  return {
    get value() {
      return shown.value;
    },
    set value(next) {
      batch(() => {
        const special = ofSketch.peek();
        if (special === null) {
          own.value = next;
          return;
        }
        if (SEARCH_KEYS.some((key) => next[key] !== special[key])) {
          ofSketch.value = searchSettingsOf(next);
        }
        own.value = { ...next, ...searchSettingsOf(own.peek()) };
      });
    },
    peek: () => shown.peek(),
  };
}
