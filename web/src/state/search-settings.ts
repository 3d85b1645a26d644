import { SET_PARTS } from '../model/brick-set.ts';

/** What the result of a search depends on beside the sketch. */
export interface SearchSettings {
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
}

/** The presets of the core (core/objective/objective.h); tests/contract/contract.test.ts asks it for each. */
export const PRESETS: readonly string[] = [
  'balanced',
  'simple',
  'faithful',
  'simple-rigid',
  'faithful-rigid',
];

export const USUAL_SEARCH: SearchSettings = Object.freeze({
  preset: 'balanced',
  seed: 1,
  effort: 1,
  off: [],
  owned: {},
  advanced: '',
});

const MAX_SEED = 2 ** 31;
const MAX_COUNT = 1e6;
const MAX_ADVANCED = 4000;
const EFFORT = { least: 0.01, most: 100 } as const;

type Readers = {
  readonly [K in keyof SearchSettings]: (value: unknown) => SearchSettings[K] | null;
};

/** One reader a field: what may come from outside, or null. */
const READERS: Readers = {
  preset: (value) => (typeof value === 'string' && PRESETS.includes(value) ? value : null),
  seed: (value) => (isWithin(value, 0, MAX_SEED) && Number.isInteger(value) ? value : null),
  effort: (value) => (isWithin(value, EFFORT.least, EFFORT.most) ? value : null),
  off: (value) => (Array.isArray(value) ? SET_PARTS.filter((id) => value.includes(id)) : null),
  owned: readCounts,
  advanced: (value) => (typeof value === 'string' && value.length <= MAX_ADVANCED ? value : null),
};

export const SEARCH_KEYS = Object.keys(USUAL_SEARCH) as readonly (keyof SearchSettings)[];

/** The settings alone, of an object that has more. */
export function searchSettingsOf(value: SearchSettings): SearchSettings {
  const { preset, seed, effort, off, owned, advanced } = value;
  return { preset, seed, effort, off, owned, advanced };
}

/** Every field that is acceptable; what is not of our parts is left out of the lists. */
export function readSearchFields(value: unknown): Partial<SearchSettings> {
  if (typeof value !== 'object' || value === null) {
    return {};
  }
  const fields = SEARCH_KEYS.flatMap((key) => {
    const read = Object.hasOwn(value, key)
      ? READERS[key]((value as Record<string, unknown>)[key])
      : null;
    return read === null ? [] : [[key, read]];
  });
  return Object.fromEntries(fields) as Partial<SearchSettings>;
}

/** Whole settings, with what is usual where a field is not acceptable; null for what are none at all. */
export function readSearchSettings(value: unknown): SearchSettings | null {
  return typeof value === 'object' && value !== null
    ? { ...USUAL_SEARCH, ...readSearchFields(value) }
    : null;
}

/** What of some settings is not acceptable: the names of fields, and of parts that are not known. */
export function unknownSettings(value: Readonly<Record<string, unknown>>): string[] {
  const known: Readonly<Record<string, unknown>> = readSearchFields(value);
  const fields = SEARCH_KEYS.filter((key) => Object.hasOwn(value, key) && !(key in known));
  const { off, owned } = value;
  const parts = [...(Array.isArray(off) ? off : []), ...Object.keys(owned ?? {})];
  return [...fields, ...parts.filter((id) => !SET_PARTS.includes(id)).map(String)];
}

function readCounts(value: unknown): Readonly<Record<string, number>> | null {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    return null;
  }
  const counts = SET_PARTS.flatMap((id) => {
    const count: unknown = Object.hasOwn(value, id) ? (value as Record<string, unknown>)[id] : null;
    return isWithin(count, 0, MAX_COUNT) && Number.isInteger(count) ? [[id, count] as const] : [];
  });
  return Object.fromEntries(counts);
}

function isWithin(value: unknown, least: number, most: number): value is number {
  return typeof value === 'number' && value >= least && value <= most;
}
