import { effect, type Signal, signal } from '@preact/signals';
import { PARTS_A_STEP } from '../model/step-size.ts';
import { readSearchFields, type SearchSettings, USUAL_SEARCH } from './search-settings.ts';

/** What the interface can be shown in. */
export type Language = 'en' | 'de';

/** What a person sets and the next visit keeps; none of it is part of a sketch. */
export interface Preferences extends SearchSettings {
  readonly language: 'auto' | Language;
  readonly theme: 'auto' | 'light' | 'dark';
  readonly autoSolve: boolean;
  readonly show: 'sketch' | 'both' | 'model';
  readonly colourBy: 'part' | 'layer' | 'axis' | 'component' | 'piece';
  readonly projection: 'perspective' | 'orthographic';
  /** Whether all lines have their lengths beside them. */
  readonly dimensions: boolean;
  /** Whether the first task is guided; over once it is done or waved away. */
  readonly guide: boolean;
  /** What a step of the instructions asks for at most. */
  readonly partsAStep: number;
}

export const PREFERENCE_DEFAULTS: Preferences = Object.freeze({
  language: 'auto',
  theme: 'auto',
  autoSolve: true,
  ...USUAL_SEARCH,
  show: 'both',
  colourBy: 'part',
  projection: 'perspective',
  dimensions: false,
  guide: true,
  partsAStep: PARTS_A_STEP.usual,
});

type PageFields = Omit<Preferences, keyof SearchSettings>;

/** One test a field: what may come back from storage. */
const ACCEPTS: { readonly [K in keyof PageFields]: (value: unknown) => boolean } = {
  language: oneOf('auto', 'en', 'de'),
  theme: oneOf('auto', 'light', 'dark'),
  autoSolve: (value) => typeof value === 'boolean',
  show: oneOf('sketch', 'both', 'model'),
  colourBy: oneOf('part', 'layer', 'axis', 'component', 'piece'),
  projection: oneOf('perspective', 'orthographic'),
  dimensions: (value) => typeof value === 'boolean',
  guide: (value) => typeof value === 'boolean',
  partsAStep: (value) =>
    typeof value === 'number' &&
    Number.isInteger(value) &&
    value >= PARTS_A_STEP.least &&
    value <= PARTS_A_STEP.most,
};

/** The part of the browser's storage that is used here. */
export type TextStorage = Pick<Storage, 'getItem' | 'setItem'>;

export const PREFERENCES_KEY = 'liftarm/preferences';

/** Every stored field that is acceptable, the default for the rest. */
export function readPreferences(text: string | null): Preferences {
  const stored = parsed(text);
  const accepted = Object.entries(stored).filter(
    ([key, value]) => Object.hasOwn(ACCEPTS, key) && ACCEPTS[key as keyof PageFields](value),
  );
  return { ...PREFERENCE_DEFAULTS, ...Object.fromEntries(accepted), ...readSearchFields(stored) };
}

function parsed(text: string | null): object {
  try {
    const value: unknown = JSON.parse(text ?? '{}');
    return typeof value === 'object' && value !== null ? value : {};
  } catch {
    return {};
  }
}

export interface PreferenceKeeping {
  readonly storage: TextStorage | null;
  /** Tells of the text whenever another tab has written it. */
  readonly onOtherTab: (take: (text: string | null) => void) => void;
  /** The browser does not keep them: said once. */
  readonly onRefused: () => void;
}

/**
 * The preferences as a signal that writes itself back, only what was changed here, and follows what other tabs change;
 * all but the language, which would load the page again under somebody's hands.
 */
export function keptPreferences(keeping: PreferenceKeeping): Signal<Preferences> {
  const { storage, onOtherTab, onRefused } = keeping;
  const read = () => storage?.getItem(PREFERENCES_KEY) ?? null;
  let last = readPreferences(read());
  const preferences = signal(last);
  let refused = false;
  effect(() => {
    const changed = differences(last, preferences.value);
    last = preferences.value;
    if (Object.keys(changed).length === 0) {
      return;
    }
    try {
      storage?.setItem(PREFERENCES_KEY, JSON.stringify({ ...parsed(read()), ...changed }));
    } catch {
      // Full or forbidden: the page works on, it only forgets.
      if (!refused) {
        onRefused();
      }
      refused = true;
    }
  });
  onOtherTab((text) => {
    last = { ...readPreferences(text), language: last.language };
    preferences.value = last;
  });
  return preferences;
}

function differences(before: Preferences, after: Preferences): Partial<Preferences> {
  const keys = Object.keys(after) as (keyof Preferences)[];
  return Object.fromEntries(
    keys.filter((key) => before[key] !== after[key]).map((key) => [key, after[key]]),
  );
}

/** The `set` of the solver's settings from lines of `key=value`; lines without `=` are left out. */
export function parseAdvanced(text: string): Record<string, number | string | boolean> {
  const result: Record<string, number | string | boolean> = {};
  for (const row of text.split('\n')) {
    const at = row.indexOf('=');
    const key = row.slice(0, Math.max(0, at)).trim();
    const value = row.slice(at + 1).trim();
    if (at > 0 && key !== '' && value !== '') {
      result[key] = typedValue(value);
    }
  }
  return result;
}

function typedValue(text: string): number | string | boolean {
  if (text === 'true' || text === 'false') {
    return text === 'true';
  }
  const number = Number(text);
  return Number.isFinite(number) ? number : text;
}

function oneOf(...allowed: readonly string[]): (value: unknown) => boolean {
  return (value) => typeof value === 'string' && allowed.includes(value);
}
