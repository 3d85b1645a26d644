import { signal } from '@preact/signals';
import { describe, expect, it } from 'vitest';
import { pagePreferences } from '../../../web/src/state/page-preferences.ts';
import {
  keptPreferences,
  PREFERENCE_DEFAULTS,
  PREFERENCES_KEY,
  parseAdvanced,
  readPreferences,
} from '../../../web/src/state/preferences.ts';
import {
  readSearchSettings,
  type SearchSettings,
  USUAL_SEARCH,
  unknownSettings,
} from '../../../web/src/state/search-settings.ts';
import { tabStorage } from '../helpers/tabs.ts';

describe('preferences', () => {
  it.each([
    null,
    '',
    'null',
    '[]',
    '{"theme":',
    '{"theme":"pink","seed":-4,"show":7}',
    '{"toString":1,"__proto__":{"theme":"dark"},"preset":"toString"}',
  ])('falls back to the defaults for %j', (stored) => {
    expect(readPreferences(stored)).toEqual(PREFERENCE_DEFAULTS);
  });

  it('keeps what is acceptable beside what is not', () => {
    expect(readPreferences('{"theme":"dark","seed":"x"}')).toEqual({
      ...PREFERENCE_DEFAULTS,
      theme: 'dark',
    });
  });

  it('forgets counts of parts that no search knows', () => {
    const { owned } = readPreferences('{"owned":{"foo":1,"2780":4,"32316":-1}}');
    expect(owned).toEqual({ '2780': 4 });
  });

  it('reads options with their types', () => {
    expect(parseAdvanced('a.b = 2.5\nflag=true\nname=fast\nbroken\n=1')).toEqual({
      'a.b': 2.5,
      flag: true,
      name: 'fast',
    });
  });
});

/** Preferences of a tab; `hear` tells it what another one wrote. */
function tab(storage: Pick<Storage, 'getItem' | 'setItem'>) {
  let hear: (text: string | null) => void = () => undefined;
  let refusals = 0;
  const preferences = keptPreferences({
    storage,
    onOtherTab: (take) => {
      hear = take;
    },
    onRefused: () => {
      refusals += 1;
    },
  });
  return {
    preferences,
    hear: () => hear(storage.getItem(PREFERENCES_KEY)),
    refusals: () => refusals,
  };
}

describe('preferences of two tabs', () => {
  it('a tab that changes one thing leaves what another has changed meanwhile', () => {
    const storage = tabStorage();
    const [a, b] = [tab(storage), tab(storage)];
    a.preferences.value = { ...a.preferences.value, owned: { '2780': 5 } };
    b.preferences.value = { ...b.preferences.value, theme: 'dark' };
    expect(tab(storage).preferences.value).toMatchObject({ owned: { '2780': 5 }, theme: 'dark' });
  });

  it('each follows the other', () => {
    const storage = tabStorage();
    const [a, b] = [tab(storage), tab(storage)];
    a.preferences.value = { ...a.preferences.value, seed: 9, language: 'de' };
    b.hear();
    expect(b.preferences.value).toMatchObject({ seed: 9, language: 'auto' });
    b.preferences.value = { ...b.preferences.value, theme: 'dark' };
    expect(tab(storage).preferences.value.language).toBe('de');
  });

  it('a storage that refuses is said once', () => {
    const refusing = {
      getItem: () => null,
      setItem: () => {
        throw new Error('QuotaExceededError');
      },
    };
    const { preferences, refusals } = tab(refusing);
    preferences.value = { ...preferences.value, seed: 2 };
    preferences.value = { ...preferences.value, seed: 3 };
    expect(refusals()).toBe(1);
  });
});

describe('settings that a sketch brought', () => {
  const own = () => signal({ ...PREFERENCE_DEFAULTS, owned: { '2780': 5 }, seed: 7 });

  it('are in force while it is on the page, and leave the person’s own as they are', () => {
    const mine = own();
    const ofSketch = signal<SearchSettings | null>(null);
    const page = pagePreferences(mine, ofSketch);
    ofSketch.value = { ...USUAL_SEARCH, effort: 4 };
    expect(page.value).toMatchObject({ effort: 4, owned: {}, seed: 1 });
    ofSketch.value = null;
    expect(page.value).toMatchObject({ effort: 1, owned: { '2780': 5 }, seed: 7 });
  });

  it('keep to themselves what is changed of them', () => {
    const mine = own();
    const ofSketch = signal<SearchSettings | null>({ ...USUAL_SEARCH });
    const page = pagePreferences(mine, ofSketch);
    page.value = { ...page.peek(), seed: 3, theme: 'dark' };
    expect(ofSketch.value?.seed).toBe(3);
    expect(mine.value).toMatchObject({ seed: 7, theme: 'dark', owned: { '2780': 5 } });
  });
});

describe('search settings from outside', () => {
  it.each([
    [{ preset: 'toString' }, {}, ['preset']],
    [{ preset: '__proto__' }, {}, ['preset']],
    [{ owned: { foo: 1 } }, { owned: {} }, ['foo']],
    [
      { owned: { '2780': 3 }, off: ['32278', 'x'] },
      { owned: { '2780': 3 }, off: ['32278'] },
      ['x'],
    ],
    [{ seed: 1.5, effort: 1e9 }, {}, ['seed', 'effort']],
    [{ advanced: 'a'.repeat(5000) }, {}, ['advanced']],
  ])('of %j what is known is taken', (value, taken, leftOut) => {
    expect(readSearchSettings(value)).toEqual({ ...USUAL_SEARCH, ...taken });
    expect(unknownSettings(value)).toEqual(leftOut);
  });
});
