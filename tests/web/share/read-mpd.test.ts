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

  it.each([
    ['0 FILE a.ldr\n0 nothing\n', 'no parts'],
    ['0 FILE a.ldr\n1 71 0 0 0 1 0 0 0 1 0 0 0 1 3001.dat\n', 'part 3001'],
    ['0 FILE a.ldr\n1 71 0 0 x 1 0 0 0 1 0 0 0 1 32316.dat\n', 'line 2'],
    ['0 FILE a.ldr\n1 71 0 0 0 1 0 0 0 1 0 0 0 1 a.ldr\n', 'nested'],
  ])('are refused with the place: %j', (text, message) => {
    const read = readMpd(text, catalogue);
    expect(read.ok ? '' : read.message).toContain(message);
  });

  it('are told from JSON and .obj', () => {
    expect(looksLikeMpd(TWO)).toBe(true);
    expect(looksLikeMpd('v 0 0 0\n')).toBe(false);
    expect(looksLikeMpd('{"a":1}')).toBe(false);
  });
});
