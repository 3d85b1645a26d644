import { effect } from '@preact/signals';
import type { PageState } from './page-state.ts';

/** Keeps the page's theme at what is chosen, or at what the system says. */
export function followTheme(state: PageState): void {
  const dark = window.matchMedia('(prefers-color-scheme: dark)');
  state.systemDark.value = dark.matches;
  dark.addEventListener('change', () => {
    state.systemDark.value = dark.matches;
  });
  effect(() => {
    document.documentElement.dataset['theme'] = state.themeName.value;
  });
}
