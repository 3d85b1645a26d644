import { describe, expect, it } from 'vitest';
import { looksLikeMpd, readMpd } from '../../../web/src/share/read-mpd.ts';
import { catalogue } from '../view/helpers/catalogue.ts';

const TWO = [
  '0 FILE Two.ldr',
  '0 Two',
  '1 71 20 -60 40 1 0 0 0 0 -1 0 1 0 32316.dat',
  '0 STEP',
  '1 4 0 0 20 1 0 0 0 1 0 0 0 1 sub.ldr',
  '0 NOFILE',
  '0 FILE sub.ldr',
  '1 16 0 0 20 1 0 0 0 1 0 0 0 1 2780.dat',
  '0 NOFILE',
].join('\r\n');

describe('.mpd files', () => {
  it('give parts in modules with Z up, through submodels and their colour', () => {
    const read = readMpd(TWO, catalogue);
    const model = JSON.parse(read.ok ? read.value : '{}') as { name: string; parts: unknown[] };
    expect(model.name).toBe('two');
    expect(model.parts).toEqual([
      { part: '32316', color: 71, position: [1, 2, 3], rotation: [1, 0, 0, 0, 0, -1, 0, 1, 0] },
      { part: '2780', color: 4, position: [0, 2, 0], rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1] },
    ]);
  });

  const BEAM = '1 71 0 0 0 1 0 0 0 1 0 0 0 1 32316.dat';
  const partsOf = (text: string) => {
    const read = readMpd(text, catalogue);
    expect(read.ok ? '' : read.message).toBe('');
    return (JSON.parse(read.ok ? read.value : '{"parts":[]}') as { parts: unknown[] }).parts;
  };

  it.each([
    'Big  bridge',
    ' Big\tbridge ',
    'Big\u00a0\u2003bridge',
    'Big\u2028bridge',
    '1 71 0 0 0',
    'FILE 0',
    '32316',
    'BIG bridge',
  ])('find submodels whatever their name: %j', (name) => {
    const sub = `${name} - 1.ldr`;
    const rows = [`0 FILE ${name}.ldr`, `1 16 0 0 0 1 0 0 0 1 0 0 0 1 ${sub}`, '0 NOFILE'];
    expect(partsOf([...rows, `0 FILE ${sub}`, BEAM, '0 NOFILE'].join('\n'))).toHaveLength(1);
  });

  it('leave out rows after the end of a submodel', () => {
    const rows = ['0 FILE a.ldr', BEAM, '0 NOFILE', BEAM, '1 is no row of any file'];
    expect(partsOf(rows.join('\n'))).toHaveLength(1);
  });

  it('may write a folder before the names of parts', () => {
    for (const folder of ['parts\\', 'parts/', 'C:\\LDraw\\parts\\']) {
      expect(partsOf(BEAM.replace('32316', `${folder}32316`))).toHaveLength(1);
    }
  });

  it('are refused where submodels multiply each other', () => {
    const level = (i: number) => [
      `0 FILE ${i}.ldr`,
      ...Array.from({ length: 30 }, () => `1 16 0 0 0 1 0 0 0 1 0 0 0 1 ${i + 1}.ldr`),
      '0 NOFILE',
    ];
    const text = Array.from({ length: 8 }, (_, i) => level(i))
      .flat()
      .join('\n');
    const read = readMpd(`${text}\n0 FILE 8.ldr\n`, catalogue);
    expect(read.ok ? '' : read.message).toContain('which is the limit');
  });

  it.each([
    ['0 FILE a.ldr\n0 nothing\n', 'no parts'],
    ['0 FILE a.ldr\n1 71 0 0 0 1 0 0 0 1 0 0 0 1 3001.dat\n', 'part 3001'],
    ['0 FILE a.ldr\n1 71 0 0 x 1 0 0 0 1 0 0 0 1 32316.dat\n', 'line 2'],
    ['0 FILE a.ldr\n1 71 0 0 0 1 0 0 0 1 0 0 0 1 a.ldr\n', 'nested'],
  ])('are refused with the place: %j', (text, message) => {
    const read = readMpd(text, catalogue);
    expect(read.ok ? '' : read.message).toContain(message);
  });

  it('that multiply without a part are refused at once', () => {
    const level = (n: number) =>
      [`0 FILE level${n}.ldr`]
        .concat(Array(30).fill(`1 16 0 0 0 1 0 0 0 1 0 0 0 1 level${n + 1}.ldr`))
        .join('\n');
    const bomb = `${[0, 1, 2, 3, 4, 5, 6, 7].map(level).join('\n')}\n0 FILE level8.ldr\n`;
    expect(bomb.length).toBeLessThan(12_000);
    const read = readMpd(bomb, catalogue);
    expect(read.ok ? '' : read.message).toContain('which is the limit');
  });

  it('are told from JSON and .obj', () => {
    expect(looksLikeMpd(TWO)).toBe(true);
    expect(looksLikeMpd('v 0 0 0\n')).toBe(false);
    expect(looksLikeMpd('{"a":1}')).toBe(false);
  });
});
