import { describe, expect, it } from 'vitest';
import { BRICK_COLOURS } from '../../../web/src/model/colours.ts';
import { COLOUR_NAMES_DE, PART_NAMES_DE } from '../../../web/src/ui/text/de/part-names.ts';
import { colourWord, partName } from '../../../web/src/ui/text/part-names.ts';
import { catalogue } from '../view/helpers/catalogue.ts';

const sorted = (keys: Iterable<string | number>) => [...keys].map(String).sort();

describe('German names of parts', () => {
  it('has one for each part of the catalogue, and for no other', () => {
    expect(sorted(Object.keys(PART_NAMES_DE))).toEqual(sorted(catalogue.parts.map(({ id }) => id)));
  });

  it('tells parts apart', () => {
    const names = Object.values(PART_NAMES_DE);
    expect(new Set(names).size).toBe(names.length);
  });

  it('says the same sizes and numbers of teeth as LDraw', () => {
    const numbers = (name: string) => name.replaceAll(',', '.').match(/\d+(\.\d+)?/g) ?? [];
    for (const { id, name, partClass, holes, thickness } of catalogue.parts) {
      const said = numbers(PART_NAMES_DE[id] ?? '').map(Number);
      if (partClass === 'gear') {
        expect(said, id).toEqual([Number(/(\d+)(?: Tooth|D$)/.exec(name)?.[1])]);
      } else if (holes > 0) {
        expect(said, id).toEqual([holes]);
        expect(PART_NAMES_DE[id]?.startsWith('Halber'), id).toBe(thickness < 1);
      } else {
        // 'Beam 2 x 4 ...' has its sizes first; half the thickness of a beam is said in words.
        const sizes = /\d[\d.]*( x \d[\d.]*)+/.exec(name.replace(' x 0.5', ''))?.[0] ?? '';
        const wanted = numbers(sizes).map(Number);
        expect(said.slice(0, wanted.length), id).toEqual(wanted);
      }
    }
  });

  it('has one for each colour', () => {
    expect(sorted(Object.keys(COLOUR_NAMES_DE))).toEqual(
      sorted(BRICK_COLOURS.map(({ code }) => code)),
    );
    expect(new Set(Object.values(COLOUR_NAMES_DE)).size).toBe(BRICK_COLOURS.length);
  });
});

describe('English names', () => {
  it('are those of LDraw, without the word that all of them share', () => {
    expect(partName('32524', catalogue)).toBe('Beam 7');
    expect(partName('no such part', catalogue)).toBe('no such part');
    expect(colourWord(71)).toBe('Light Bluish Grey');
  });
});
