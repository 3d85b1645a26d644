import { type Language, PREFERENCES_KEY, readPreferences } from '../../state/preferences.ts';

/** The shape of a table of words: the same keys, any words. A missing key does not compile. */
export type Words<T> = T extends string
  ? string
  : T extends (...args: never[]) => unknown
    ? T
    : { readonly [K in keyof T]: Words<T[K]> };

/** Names of the languages, each in itself. */
export const LANGUAGES: Readonly<Record<Language, string>> = { en: 'English', de: 'Deutsch' };

/**
 * The language of this visit: `?lang=` in the address, else what was chosen, else what the browser
 * asks for, else English. Chosen once: a change takes effect with the next load of the page.
 */
export const language: Language = chosenLanguage();

/**
 * The words of the language in use. An area of the interface has one file a language, such as
 * `en/checks.ts` and `de/checks.ts`, and calls this once in a file of its own.
 * @param en the English words, `as const`; they give the shape.
 * @param de the German ones, typed `Words<typeof EN>`.
 */
export function chooseWords<T>(en: T, de: Words<T>): Words<T> {
  return language === 'de' ? de : (en as Words<T>);
}

/** The words of a file that has them by language, such as `{"en": "Chair", "de": "Stuhl"}`; '' if it has none. */
export function inLanguage(value: unknown, wanted: Language = language): string {
  if (typeof value === 'string') {
    return value;
  }
  const words = (typeof value === 'object' && value !== null ? value : {}) as Record<
    string,
    unknown
  >;
  const found = words[wanted] ?? words['en'];
  return typeof found === 'string' ? found : '';
}

/** A number as this language writes it. */
export function formatNumber(value: number, digits = 0): string {
  return value.toLocaleString(language, {
    minimumFractionDigits: digits,
    maximumFractionDigits: digits,
  });
}

/** A point in modules, such as `(8, 0, 2.5)`. */
export function formatPoint(point: readonly number[]): string {
  const values = point.map((value) => value.toLocaleString(language, { maximumFractionDigits: 2 }));
  // A comma that is a decimal sign already does not part numbers too.
  return `(${values.join(language === 'de' ? '; ' : ', ')})`;
}

function chosenLanguage(): Language {
  if (typeof document === 'undefined') {
    return 'en';
  }
  const asked = new URLSearchParams(location.search).get('lang');
  const { language: kept } = readPreferences(stored());
  const wanted = [asked, kept, ...(kept === 'auto' ? navigator.languages : []), 'en'];
  const known = wanted.flatMap((tag) => languageOf(tag));
  return known[0] ?? 'en';
}

/** The language that a tag such as `de-AT` asks for, if we speak it. */
function languageOf(tag: string | null): Language[] {
  const base = (tag ?? '').slice(0, 2).toLowerCase();
  return base === 'en' || base === 'de' ? [base] : [];
}

function stored(): string | null {
  try {
    return window.localStorage.getItem(PREFERENCES_KEY);
  } catch {
    return null;
  }
}
