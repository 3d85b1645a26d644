import { readFileSync } from 'node:fs';
import { type Catalogue, type Part, readCatalogue } from '../../../../web/src/model/catalogue.ts';

const file = new URL('../../../../core/parts/catalogue.json', import.meta.url);

/** The catalogue that the program ships. */
export const catalogue: Catalogue = readCatalogue(JSON.parse(readFileSync(file, 'utf8')));

/** A part that must be there. */
export function partOf(id: string): Part {
  const part = catalogue.find(id);
  if (!part) {
    throw new Error(`no part ${id} in the catalogue`);
  }
  return part;
}
