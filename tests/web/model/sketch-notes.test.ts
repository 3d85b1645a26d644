import { expect, test } from 'vitest';
import { readSketchNotes } from '../../../web/src/model/sketch-notes.ts';

const NOTE = {
  kind: 'near',
  message: 'lines[0] and lines[1] come within 0.09 modules',
  at: [3, 0, 0],
  lines: [0, 1],
  mend: [{ line: 1, from: [3, 0, 0], to: [3, 0, 5] }],
};

test('notes of the core are taken as they are', () => {
  expect(readSketchNotes(JSON.stringify({ symmetries: [], notes: [NOTE] }))).toEqual([NOTE]);
});

test.each([
  ['no JSON', '{'],
  ['no notes', '{}'],
  ['null', 'null'],
  ['a note of an unknown kind', JSON.stringify({ notes: [{ ...NOTE, kind: 'far' }] })],
  ['a note at no place', JSON.stringify({ notes: [{ ...NOTE, at: [3, 0] }] })],
  ['a mend without an end', JSON.stringify({ notes: [{ ...NOTE, mend: [{ from: [0, 0, 0] }] }] })],
])('%s gives none', (_, answer) => {
  expect(readSketchNotes(answer)).toEqual([]);
});
