import { describe, expect, it } from 'vitest';
import {
  PREFERENCE_DEFAULTS,
  parseAdvanced,
  readPreferences,
} from '../../../web/src/state/preferences.ts';

describe('preferences', () => {
  it.each([null, '', 'null', '[]', '{"theme":', '{"theme":"pink","seed":-4,"show":7}'])(
    'falls back to the defaults for %j',
    (stored) => {
      expect(readPreferences(stored)).toEqual(PREFERENCE_DEFAULTS);
    },
  );

  it('keeps what is acceptable beside what is not', () => {
    expect(readPreferences('{"theme":"dark","seed":"x"}')).toEqual({
      ...PREFERENCE_DEFAULTS,
      theme: 'dark',
    });
  });

  it('reads options with their types', () => {
    expect(parseAdvanced('a.b = 2.5\nflag=true\nname=fast\nbroken\n=1')).toEqual({
      'a.b': 2.5,
      flag: true,
      name: 'fast',
    });
  });
});
