import { describe, expect, it } from 'vitest';
import { brickSetSettings, SET_PARTS, shortages } from '../../../web/src/model/brick-set.ts';
import { readPartsList } from '../../../web/src/model/parts-list.ts';

const KNOWN = new Set([...SET_PARTS, '3648b']);

function listOf(text: string) {
  const list = readPartsList(text, KNOWN);
  return list.ok ? list.value : null;
}

function counts(text: string): Record<string, number> | string {
  const list = readPartsList(text, KNOWN);
  return list.ok ? Object.fromEntries(list.value.counts) : list.message;
}

describe('a list of owned parts', () => {
  it.each([
    ['our own table', 'Part,Color,Quantity\n32524,71,4\n32524,0,2\n2780,0,30\n'],
    ['our own sheet', 'Name,Number,Colour,Count\n"Beam 7","32524",x,6\nPin,2780,x,30\nSum,,,36\n'],
    ['semicolons and other names', 'Color;Qty;Part_num\n71;6;32524\n0;30;2780\n'],
    ['quoted cells', '"Part","Quantity"\n"32524","6"\n"2780","30"\n'],
    ['commas in names', 'Part,Name,Quantity\n32524,"Technic, Beam",6\n2780,"a ""pin""",30\n'],
    ['titles above', 'My parts\n\nsep;no\nPart;Quantity\n32524;6\n2780;30\n'],
    ['a row that names the sign', 'sep=;\nPart;Color;Quantity\n32524;71;6\n2780;0;30\n'],
    ['element numbers beside', 'ElementId\tLdrawId\tQty\n4495935\t32524.dat\t6\n1\t2780.dat\t30\n'],
    ['counts called numbers', 'Number,Part,Colour\n6,32524,Gray\n30,2780,Black\n'],
    ['German names', 'Teil;Farbe;Anzahl\n32524;Grau;6\n2780;Schwarz;30\n'],
    ['old ends of line', 'Part,Quantity\r32524,6\r2780,30\r'],
    ['plain rows', '32524 6\n2780 30\n'],
    ['plain rows of other habits', '32524 x 4\n2780: 30\n2x 32524\n'],
    ['counts of other habits', 'Part,Quantity\n32524,4.0\n32524,x2\n2780," 30 "\n'],
    [
      'XML',
      '<INVENTORY><ITEM><ITEMTYPE>P</ITEMTYPE><ITEMID>32524</ITEMID><QTY>6</QTY></ITEM>' +
        '<ITEM><ITEMTYPE>S</ITEMTYPE><ITEMID>8880</ITEMID></ITEM>' +
        '<item><itemid>2780</itemid><minqty>30</minqty></item></INVENTORY>',
    ],
  ])('is read from %s', (_name, text) => {
    expect(counts(text)).toEqual({ '32524': 6, '2780': 30 });
  });

  it('knows other numbers of a part: moulds, prints, and those under which it is sold', () => {
    const rows =
      '64871 3\n61332 25\n4459 5\n32316pr0001 2\n32524b 3\n3713a 4\n6590 12\n42924 7\n3648b 1\n';
    expect(counts(rows)).toEqual({
      '32278': 3,
      '2780': 30,
      '32316': 2,
      '32524': 3,
      '3713': 16,
      '6558': 7,
      // Its own letter is no mould of another.
      '3648b': 1,
    });
  });

  it('tells which rows it does not understand, and why', () => {
    const list = listOf('Part,Quantity\n4495935,4\n32524,\n,5\n2780,"1,200"\n32316,-1\n');
    expect(list?.rows).toBe(4);
    expect(list?.odd.map(({ row, why }) => [row, why])).toEqual([
      [2, 'part'],
      [3, 'count'],
      [6, 'count'],
    ]);
    expect([...(list?.counts ?? [])]).toEqual([['2780', 1200]]);
  });

  it('may be understood nowhere', () => {
    const list = listOf('elementId,partId,quantity\n1,4495935,4\n2,4142865,6\n');
    expect(list?.odd).toHaveLength(2);
    expect(list?.counts.size).toBe(0);
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
