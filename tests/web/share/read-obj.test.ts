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

  it.each([
    ['v 0 0\nl 1 1\n', 'line 1'],
    ['v 0 0 x\n', 'line 1'],
    ['v 0 0 0\nl 1 7\n', 'no vertex 7'],
    ['v 0 0 0\nl 1\n', 'at least two'],
    ['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', 'a surface'],
    ['v 0 0 0\n', 'no line segments'],
    ['v 0 0 99999\n', 'at most 2000'],
  ])('are refused with the place: %j', (text, message) => {
    const read = readObj(text, '');
    expect(read.ok ? '' : read.message).toContain(message);
  });

  it('are told from JSON', () => {
    expect(looksLikeObj('# x\n\nv 0 0 0\n')).toBe(true);
    expect(looksLikeObj('{"format":"technic-sketch"}')).toBe(false);
  });
});
