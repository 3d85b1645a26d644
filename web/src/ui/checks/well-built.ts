import type { WellBuiltItem } from '../../model/report.ts';
import { formatNumber } from '../text/language.ts';
import { builtWords as words } from './built-words.ts';

const HUNDREDTHS = 2;

/** An item in a few words: its number, or how many numbers fall short. */
export function builtNumber(item: WellBuiltItem): string {
  if (!item.applies) {
    return words.notAsked;
  }
  const value = (name: string) => item.figures[name] ?? 0;
  const count = (name: string) => formatNumber(value(name));
  switch (item.id) {
    case 'faithful':
      return words.layers(formatNumber(value('meanLayer'), HUNDREDTHS));
    case 'stands':
      return shortfalls([
        [value('fallsOver'), words.falls],
        [value('belowBase'), words.below(count('belowBase'))],
        [value('liftedFeet'), words.lifted(count('liftedFeet'))],
      ]);
    case 'stiff':
      return shortfalls([
        [value('freedomsBeyondJoints'), words.loose(count('freedomsBeyondJoints'))],
        [value('beamsOnOneAxis'), words.turning(count('beamsOnOneAxis'))],
      ]);
    case 'clean':
      return words.naked(count('nakedHeads'), count('heads'));
    case 'symmetric':
      return words.mirrored(count('mirroredBeams'), count('beams'));
    case 'few':
      return words.parts(count('parts'), count('kinds'));
    default:
      return '';
  }
}

function shortfalls(all: readonly (readonly [number, string])[]): string {
  const said = all.flatMap(([value, text]) => (value > 0 ? [text] : []));
  return said.length > 0 ? said.join(', ') : words.good;
}

/** The parts that an item, or one place of it, lights. */
export function litParts(item: WellBuiltItem, place: number | null): Set<number> {
  const places = place === null ? item.places : item.places.slice(place, place + 1);
  return new Set(places.flatMap(({ parts }) => parts ?? []));
}
