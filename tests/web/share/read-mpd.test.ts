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
    [
      '0 FILE a.ldr\n1 71 0 0 0 1 0 0 0 1 0 0 0 1 3001.dat\n',
      'not known here are not judged: 3001 (1)',
    ],
    ['0 FILE a.ldr\n1 71 0 0 x 1 0 0 0 1 0 0 0 1 32316.dat\n', 'line 2'],
    ['0 FILE a.ldr\n1 71 0 0 0 1 0 0 0 1 0 0 0 1 a.ldr\n', 'holds itself'],
  ])('are refused with the place: %j', (text, message) => {
    const read = readMpd(text, catalogue);
    expect(read.ok ? '' : read.message).toContain(message);
  });

  const placedAs = (row: string) => partsOf(`0 x\n${row}\n`)[0] as { part: string; color: number };

  it('name parts by other numbers too', () => {
    expect(placedAs(BEAM.replace('32316', '64871')).part).toBe('32278');
    expect(placedAs(BEAM.replace('32316.dat', '3713A.DAT')).part).toBe('3713');
    expect(placedAs(BEAM.replace('32316.dat', '32316')).part).toBe('32316');
  });

  it.each([
    ['0x2FF8800', 191],
    ['#2B40000', 4],
    ['16', 7],
    ['24', 7],
    ['40', 71],
  ])('have colour %s in the nearest or the usual one', (colour, code) => {
    expect(placedAs(BEAM.replace('71', colour)).color).toBe(code);
  });

  it('have what is not known as guests, and say so by kind and count', () => {
    const brick = BEAM.replace('32316', '3001');
    const notes: string[] = [];
    const rows = ['0 x', BEAM, brick, brick, BEAM.replace('32316.dat', 'wheels.ldr')];
    const read = readMpd(rows.join('\r'), catalogue, { note: (sentence) => notes.push(sentence) });
    expect(read.ok && JSON.parse(read.value).parts).toHaveLength(1);
    expect(notes).toEqual([
      'parts that are not known here are not judged: 3001 (2)',
      'what stands in another file is left out: wheels.ldr',
    ]);
  });

  it('keep the first of two submodels with one name, and say so', () => {
    const notes: string[] = [];
    const text = `0 FILE a.ldr\n1 16 0 0 0 1 0 0 0 1 0 0 0 1 s.ldr\n0 FILE s.ldr\n${BEAM}\n${BEAM}\n0 FILE S.ldr\n${BEAM}\n`;
    const read = readMpd(text, catalogue, { note: (sentence) => notes.push(sentence) });
    expect(read.ok && JSON.parse(read.value).parts).toHaveLength(2);
    expect(notes).toEqual(['s.ldr stands there more than once; the first counts']);
  });

  it('may be nested deep', () => {
    const level = (n: number) => `0 FILE l${n}.ldr\n1 16 0 0 0 1 0 0 0 1 0 0 0 1 l${n + 1}.ldr\n`;
    const text = `${Array.from({ length: 20 }, (_, n) => level(n)).join('')}0 FILE l20.ldr\n${BEAM}\n`;
    expect(partsOf(text)).toHaveLength(1);
  });

  it('place a part that is its own mirror image as one that is turned', () => {
    const mirrored = '1 71 0 0 0 0 0 1 0 1 0 1 0 0 32316.dat';
    const { rotation } = placedAs(mirrored) as unknown as { rotation: number[] };
    const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0, i = 0] = rotation;
    expect(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)).toBe(1);
    // Its holes lie along the same line as before.
    const known = catalogue.find('32316');
    const holes = (m: readonly number[]) =>
      known?.features
        .map(({ center: [x, y, z] }) =>
          [0, 3, 6].map((r) =>
            ((m[r] ?? 0) * x + (m[r + 1] ?? 0) * y + (m[r + 2] ?? 0) * z + 0).toFixed(3),
          ),
        )
        .map(String)
        .sort();
    const asWritten = [0, -1, 0, 1, 0, 0, 0, 0, 1];
    expect(holes(rotation)?.length).toBe(5);
    expect(new Set(holes(rotation))).toEqual(new Set(holes(asWritten.map((x) => x + 0))));
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
    for (const begin of ['0\n', '// made elsewhere\n', '\uFEFF0 FILE a.ldr\r', '0\tx\n', '']) {
      expect(looksLikeMpd(`${begin}${BEAM.replace(' 32316', '  32316')}\n`)).toBe(true);
    }
    expect(looksLikeMpd('1 2 3\n')).toBe(false);
  });
});
