import { describe, expect, it } from 'vitest';
import { brickSetSettings, SET_PARTS, shortages } from '../../../web/src/model/brick-set.ts';
import { readPartsList } from '../../../web/src/model/parts-list.ts';

function counts(text: string): Record<string, number> | string {
  const list = readPartsList(text);
  return list.ok ? Object.fromEntries(list.value) : list.message;
}

describe('a list of owned parts', () => {
  it.each([
    ['our own table', 'Part,Color,Quantity\n32524,71,4\n32524,0,2\n2780,0,30\n'],
    ['semicolons and other names', 'Color;Qty;Part_num\n71;6;32524\n0;30;2780\n'],
    ['quoted cells', '"Part","Quantity"\n"32524","6"\n"2780","30"\n'],
    ['plain rows', '32524 6\n2780 30\n'],
  ])('is read from %s', (_name, text) => {
    expect(counts(text)).toEqual({ '32524': 6, '2780': 30 });
  });

  it('leaves out rows that say nothing', () => {
    expect(counts('Part,Quantity\n32524,-1\n,5\n2780,3\n')).toEqual({ '2780': 3 });
  });

  it('is refused in one sentence when no row fits', () => {
    expect(counts('hello world')).toMatch(/no row has a part number and a count/);
    expect(counts('  \n')).toMatch(/empty/);
  });
});

describe('the brick set', () => {
  it('asks for nothing when every part is on', () => {
    expect(brickSetSettings(new Set())).toEqual({});
  });

  it('leaves out the beams and connectors that are off', () => {
    expect(brickSetSettings(new Set(['32278', '6558']))).toEqual({
      lengths: '2,3,5,6,7,9,11,13',
      connectors: '2780,87082,48989,55615,15462,3713,18654,15100,44809',
    });
  });

  it('leaves out the bent beams that are off', () => {
    expect(brickSetSettings(new Set(['32140', '60484']))).toEqual({
      bent: '32271,32348,32526,6629',
    });
  });

  it('leaves out the frames that are off', () => {
    expect(brickSetSettings(new Set(['64179']))).toEqual({ frames: '14720,64178' });
  });

  it('leaves out an axle that joins stacks as well from both', () => {
    expect(brickSetSettings(new Set(['15462']))).toEqual({
      axles: '4519,24316,3705,87083,32073,3706,44294,3707,55013,60485,3737,23948,3708',
      connectors: '2780,6558,87082,48989,55615,3713,18654,15100,44809',
    });
  });

  it('keeps the pin that nothing works without', () => {
    expect(brickSetSettings(new Set(SET_PARTS))).toEqual({
      bent: '',
      frames: '',
      axles: '',
      connectors: '2780',
    });
  });

  it('adds up colours when it says what is missing', () => {
    const needed = [
      { part: '32524', count: 4 },
      { part: '32524', count: 3 },
      { part: '2780', count: 50 },
    ];
    expect(Object.fromEntries(shortages(needed, { '32524': 5 }))).toEqual({ '32524': 2 });
  });
});
