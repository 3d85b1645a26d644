import { brickSetSettings } from '../model/brick-set.ts';
import type { SolveSettings } from '../solver/protocol.ts';
import { type Preferences, parseAdvanced } from '../state/preferences.ts';

/** What the search is asked for. What stands under "advanced" wins over everything else. */
export function settingsOf(
  preferences: Pick<Preferences, 'seed' | 'preset' | 'effort' | 'off' | 'advanced'> &
    Partial<Pick<Preferences, 'owned'>>,
): SolveSettings {
  const { seed, preset, effort, off, owned = {}, advanced } = preferences;
  const limits = Object.entries(owned).map(([id, count]) => [`owned.${id}`, count]);
  const set = {
    ...(effort === 1 ? {} : { effort }),
    ...brickSetSettings(new Set(off)),
    ...Object.fromEntries(limits),
    ...parseAdvanced(advanced),
  };
  return { seed, preset, set };
}

/** Settings that say which parts there are, and how many. */
const OF_PARTS = /^(?:owned\..*|lengths|bent|frames|axles|connectors)$/;

/** What settings say of the parts that a search may use, as text: equal texts, equal parts. */
export function partsText({ set = {} }: SolveSettings): string {
  const ofParts = Object.entries(set).filter(([key]) => OF_PARTS.test(key));
  return JSON.stringify(ofParts.sort(([a], [b]) => (a < b ? -1 : 1)));
}
