import { describe, expect, it } from 'vitest';
import { readSketch, writeSketch } from '../../../web/src/state/read-sketch.ts';

const sketch = (fields: string) => `{"format":"technic-sketch","version":1,${fields}}`;
const oneLine = (from: string, to: string) => sketch(`"lines":[{"from":${from},"to":${to}}]`);

describe('readSketch', () => {
  it.each([
    ['empty', '', 'the file is empty'],
    ['broken JSON', '{"format":', 'not JSON'],
    ['another format', '{"format":"x","version":1,"lines":[]}', 'format:'],
    ['a later version', '{"format":"technic-sketch","version":3,"lines":[]}', 'version:'],
    ['no lines', sketch('"name":"a"'), 'lines: should be a list'],
    [
      'a text for a number',
      oneLine('[0,0,"a"]', '[1,0,0]'),
      'lines[0].from[2]: should be a number',
    ],
    ['too few numbers', oneLine('[0,0]', '[1,0,0]'), 'lines[0].from: should be three numbers'],
    ['a length of 4.5', oneLine('[0,0,0]', '[4.5,0,0]'), 'length 4.5 is not a whole number'],
    ['a space diagonal', oneLine('[0,0,0]', '[2,3,6]'), 'no plane parallel'],
    ['a point', oneLine('[0,0,0]', '[0,0,0]'), 'same point'],
    ['a far point', oneLine('[0,0,0]', '[9999,0,0]'), 'beyond the limit'],
    ['NaN', oneLine('[0,0,NaN]', '[1,0,0]'), 'not JSON'],
  ])('refuses %s in one sentence', (_name, text, message) => {
    const read = readSketch(text);
    expect(read.ok).toBe(false);
    expect(read.ok ? '' : read.message).toContain(message);
  });

  it('writes what it reads', () => {
    const text = sketch(
      '"name":"Seesaw","lines":[{"from":[0,0,0],"to":[6,0,0],"exact":true,"holeAxis":"y"}],' +
        '"joints":[{"at":[3,0,0],"axis":[0,1,0]}],"keepOut":[{"min":[0,0,0],"max":[1,1,1]}],"ground":0',
    );
    const read = readSketch(text);
    expect(read.ok && JSON.parse(writeSketch(read.value))).toEqual(JSON.parse(text));
  });
});
