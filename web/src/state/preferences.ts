import { effect, type Signal, signal } from '@preact/signals';

/** What the interface can be shown in. */
export type Language = 'en' | 'de';

/** What a person sets and the next visit keeps; none of it is part of a sketch. */
export interface Preferences {
  readonly language: 'auto' | Language;
  readonly theme: 'auto' | 'light' | 'dark';
  readonly autoSolve: boolean;
  readonly preset: string;
  readonly seed: number;
  /** How long to search, as a multiple of what is usual. */
  readonly effort: number;
  /** Parts that the search must not use. */
  readonly off: readonly string[];
  /** How many there are of each part; parts that are not counted are plenty. */
  readonly owned: Readonly<Record<string, number>>;
  /** Single solver options, one `key=value` a line, as `liftarm solve --set`. */
  readonly advanced: string;
  readonly show: 'sketch' | 'both' | 'model';
  readonly colourBy: 'part' | 'layer' | 'axis' | 'component' | 'piece';
  readonly projection: 'perspective' | 'orthographic';
  /** Whether the first task is guided; over once it is done or waved away. */
  readonly guide: boolean;
}

export const PREFERENCE_DEFAULTS: Preferences = Object.freeze({
  language: 'auto',
  theme: 'auto',
  autoSolve: true,
  preset: 'simple',
  seed: 1,
  effort: 1,
  off: [],
  owned: {},
  advanced: '',
  show: 'both',
  colourBy: 'part',
  projection: 'perspective',
  guide: true,
});

/** One test a field: what may come back from storage. */
const ACCEPTS: { readonly [K in keyof Preferences]: (value: unknown) => boolean } = {
  language: oneOf('auto', 'en', 'de'),
  theme: oneOf('auto', 'light', 'dark'),
  autoSolve: (value) => typeof value === 'boolean',
  preset: (value) => typeof value === 'string' && value.length < 60,
  seed: (value) => Number.isInteger(value) && Number(value) >= 0 && Number(value) <= 2 ** 31,
  effort: (value) => typeof value === 'number' && value >= 0.01 && value <= 100,
  off: (value) => Array.isArray(value) && value.length < 200 && value.every(isPartNumber),
  owned: isCounts,
  advanced: (value) => typeof value === 'string' && value.length < 4000,
  show: oneOf('sketch', 'both', 'model'),
  colourBy: oneOf('part', 'layer', 'axis', 'component', 'piece'),
  projection: oneOf('perspective', 'orthographic'),
  guide: (value) => typeof value === 'boolean',
};

/** The part of the browser's storage that is used here. */
export type TextStorage = Pick<Storage, 'getItem' | 'setItem'>;

export const PREFERENCES_KEY = 'liftarm/preferences';

/** Every stored field that is acceptable, the default for the rest. */
export function readPreferences(text: string | null): Preferences {
  let stored: unknown;
  try {
    stored = JSON.parse(text ?? '{}');
  } catch {
    stored = {};
  }
  if (typeof stored !== 'object' || stored === null) {
    return PREFERENCE_DEFAULTS;
  }
  const accepted = Object.entries(stored).filter(
    ([key, value]) => key in ACCEPTS && ACCEPTS[key as keyof Preferences](value),
  );
  return { ...PREFERENCE_DEFAULTS, ...Object.fromEntries(accepted) };
}

/** The preferences as a signal that writes itself back. A storage that refuses is not an error. */
export function keptPreferences(storage: TextStorage | null): Signal<Preferences> {
  const preferences = signal(readPreferences(storage?.getItem(PREFERENCES_KEY) ?? null));
  effect(() => {
    const text = JSON.stringify(preferences.value);
    try {
      storage?.setItem(PREFERENCES_KEY, text);
    } catch {
      // Full or forbidden: the page works on, it only forgets.
    }
  });
  return preferences;
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

function isPartNumber(value: unknown): boolean {
  return typeof value === 'string' && /^[\w-]{1,20}$/.test(value);
}

function isCounts(value: unknown): boolean {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    return false;
  }
  const entries = Object.entries(value);
  const good = ([id, count]: [string, unknown]) =>
    isPartNumber(id) && Number.isInteger(count) && Number(count) >= 0;
  return entries.length < 500 && entries.every(good);
}
