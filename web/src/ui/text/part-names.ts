import type { Catalogue } from '../../model/catalogue.ts';
import { colourName } from '../../model/colours.ts';
import { language } from './language.ts';

// The catalogue has LDraw's English names. Other languages have a table by part number of their own.

interface PartWords {
  readonly parts: Readonly<Record<string, string>>;
  readonly colours: Readonly<Record<number, string>>;
}

let words: PartWords = { parts: {}, colours: {} };

/** Fetches the table of the language in use. Until it is there, or where it is missing, names stay English. */
export async function loadPartNames(): Promise<void> {
  if (language === 'de') {
    const table = await import('./de/part-names.ts').catch(() => null);
    words = table ? { parts: table.PART_NAMES_DE, colours: table.COLOUR_NAMES_DE } : words;
  }
}

/** What a part is called in the language in use; its number if the catalogue does not have it. */
export function partName(id: string, catalogue: Pick<Catalogue, 'find'>): string {
  return words.parts[id] ?? shortName(catalogue.find(id)?.name ?? id);
}

/** What the colour of an LDraw code is called in the language in use. */
export function colourWord(code: number): string {
  return words.colours[code] ?? colourName(code);
}

/** Every part here is a Technic part, so the word says nothing. */
function shortName(name: string): string {
  return name.replace(/^Technic\s+/, '');
}
