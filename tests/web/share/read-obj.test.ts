import { describe, expect, it } from 'vitest';
import { looksLikeObj, readObj } from '../../../web/src/share/read-obj.ts';

describe('.obj files of line segments', () => {
  it('become lines, each once', () => {
    const read = readObj('o frame\nv 0 0 0\nv 4 0 0\nv 4 2.9999999 0\nl 1 2 3\nl 2 1\n', 'Frame');
    expect(read).toEqual({
      ok: true,
      value: {
        format: 'technic-sketch',
        version: 1,
        name: 'Frame',
        lines: [
          { from: [0, 0, 0], to: [4, 0, 0] },
          { from: [4, 0, 0], to: [4, 3, 0] },
        ],
      },
    });
  });

  it('count negative numbers from the end', () => {
    const read = readObj('v 0 0 0\nv 0 0 5\nl -2 -1\n', '');
    expect(read.ok && read.value.lines).toEqual([{ from: [0, 0, 0], to: [0, 0, 5] }]);
  });

  const linesIn = (text: string) => {
    const notes: string[] = [];
    const read = readObj(text, '', (note) => notes.push(note));
    expect(read.ok ? '' : read.message).toBe('');
    return { lines: read.ok ? read.value.lines : [], notes };
  };
  const SIX = [{ from: [0, 0, 0], to: [6, 0, 0] }];

  it.each([
    ['old ends of line', 'v 0 0 0\rv 6 0 0\rl 1 2\r'],
    ['a row that goes on', 'v 0 0 0\nv 6 0 0\nl 1 \\\n2\n'],
    ['vertices after lines', 'l 1 2\nv 0 0 0\nv 6 0 0\n'],
    ['capital letters', 'V 0 0 0\nV 6 0 0\nL 1 2\n'],
    [
      'a curve of straight pieces',
      'v 0 0 0\nv 6 0 0\ncstype bspline\ndeg 1\ncurv 0.0 1.0 1 2\nparm u 0 1\nend\n',
    ],
    ['texture numbers', 'v 0 0 0\nv 6 0 0\nl 1/1 2/2\n'],
  ])('may have %s', (_name, text) => {
    expect(linesIn(text)).toEqual({ lines: SIX, notes: [] });
  });

  it.each([
    ['millimetres, said', '# units mm\nv 0 0 0\nv 48 0 0\nl 1 2\n', 'millimetres'],
    ['millimetres, guessed', 'v 0 0 0\nv 48 0 0\nl 1 2\n', 'millimetres'],
    ['metres, guessed', 'v 0 0 0\nv 0.048 0 0\nl 1 2\n', 'metres'],
    ['centimetres, said', '# in cm\nv 0 0 0\nv 4.8 0 0\nl 1 2\n', 'centimetres'],
  ])('may be in %s', (_name, text, unit) => {
    const { lines, notes } = linesIn(text);
    expect(lines).toEqual(SIX);
    expect(notes).toEqual([`its numbers were taken for ${unit}; a module is 8 mm`]);
  });

  it('stay as long as they are where no unit is to be seen', () => {
    expect(linesIn('v 0 0 0\nv 43 0 0\nl 1 2\n').lines[0]?.to).toEqual([43, 0, 0]);
  });

  /** Three legs of five under a bar of eight. */
  const TRIPOD = ['0 0 0', '0 5 0', '8 5 0', '8 0 0', '4 5 0', '4 0 0']
    .map((at) => `v ${at}`)
    .join('\n');

  it('stand on their feet where Y is up', () => {
    const { lines, notes } = linesIn(`${TRIPOD}\nl 1 2 5 3 4\nl 5 6\n`);
    expect(notes).toEqual(['it was turned so that its Y is up']);
    expect(lines[0]).toEqual({ from: [0, 0, 0], to: [0, 0, 5] });
  });

  it('are turned where a comment says so, and left where it says otherwise', () => {
    const bar = 'v 0 0 0\nv 0 5 0\nl 1 2\n';
    expect(linesIn(`# Y up\n${bar}`).lines[0]?.to).toEqual([0, 0, 5]);
    expect(linesIn(`# Z up\n${TRIPOD}\nl 1 2 5 3 4\nl 5 6\n`).notes).toEqual([]);
  });

  it.each([
    ['v 0 0\nl 1 1\n', 'line 1'],
    ['v 0 0 x\n', 'line 1'],
    ['v 0 0 0\nl 1 7\n', 'no vertex 7'],
    ['v 0 0 0\nl 1\n', 'at least two'],
    ['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', 'a surface'],
    ['v 0 0 0\n', 'no line segments'],
    ['v 0 0 0\nv 0 0 99999\nl 1 2\n', 'more than 2000 modules'],
    ['v 0,0 0,0 0,0\nv 6,0 0,0 0,0\nl 1 2\n', 'line 1: a decimal comma; write 0.0'],
  ])('are refused with the place: %j', (text, message) => {
    const read = readObj(text, '');
    expect(read.ok ? '' : read.message).toContain(message);
  });

  it('are told from JSON', () => {
    expect(looksLikeObj('# x\n\nv 0 0 0\n')).toBe(true);
    expect(looksLikeObj('{"format":"technic-sketch"}')).toBe(false);
  });
});
