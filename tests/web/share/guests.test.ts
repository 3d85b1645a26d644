import { describe, expect, it } from 'vitest';
import { readModel } from '../../../web/src/app/read-model.ts';
import { withGuestsAsParts } from '../../../web/src/model/guests.ts';
import type { Model } from '../../../web/src/model/model.ts';
import { readMpd } from '../../../web/src/share/read-mpd.ts';
import { catalogue } from '../view/helpers/catalogue.ts';

const HOME = '0 0 0 1 0 0 0 1 0 0 0 1';
const BEAM = `1 71 ${HOME} 32316.dat`;
const SIZES = { 3001: ['Brick 2 x 4', -2, -1, -1.2, 2, 1, 0] };
const SHAPE = [
  '0 Lever',
  '2 24 0 0 0 20 0 0',
  '3 16 0 0 0 20 0 0 0 40 0',
  '4 16 0 0 0 20 0 0 20 0 20 0 0 20',
];

function read(rows: readonly string[], sizes = {}): Model {
  const json = readMpd(rows.join('\n'), catalogue, { sizes });
  expect(json.ok ? '' : json.message).toBe('');
  const model = readModel(json.ok ? json.value : '');
  if (!model.ok) {
    throw new Error(model.message);
  }
  return model.value;
}

describe('parts that the catalogue does not hold', () => {
  it('follow those that it holds, in their place and colour', () => {
    const { parts, guests } = read([`1 4 0 -20 40 1 0 0 0 1 0 0 0 1 3001.dat`, BEAM]);
    expect(guests?.count).toBe(1);
    expect(parts.map(({ part }) => part)).toEqual(['32316', '3001']);
    expect(parts[1]).toMatchObject({ color: 4, position: [0, 2, 1] });
  });

  it('have the name and the box of a table, also as another mould of it', () => {
    const { guests } = read([BEAM, `1 4 ${HOME} 3001a.dat`], SIZES);
    expect(guests?.kinds).toMatchObject([
      { id: '3001a', name: 'Brick 2 x 4', min: [-2, -1, -1.2], max: [2, 1, 0], faces: [] },
    ]);
  });

  it('have the shape that the document holds, in modules with Z up', () => {
    const file = ['0 FILE a.ldr', BEAM, `1 4 ${HOME} lever.dat`, '0 FILE lever.dat', ...SHAPE];
    const [kind] = read(file).guests?.kinds ?? [];
    expect(kind?.name).toBe('Lever');
    expect(kind?.faces).toHaveLength(3 * 9);
    expect(kind?.faces.slice(0, 9)).toEqual([0, 0, 0, 1, 0, 0, 0, 0, -2]);
    expect(kind?.lines).toEqual([0, 0, 0, 1, 0, 0]);
  });

  it('are drawn by what they refer to within the document', () => {
    const inner = '1 16 0 0 20 1 0 0 0 1 0 0 0 1 s\\face.dat';
    const file = ['0 FILE a.ldr', BEAM, `1 4 ${HOME} lever.dat`, '0 FILE lever.dat', inner];
    const [kind] = read([...file, '0 FILE s\\face.dat', ...SHAPE]).guests?.kinds ?? [];
    expect(kind?.faces.slice(0, 3)).toEqual([0, 1, 0]);
  });

  it('are not what a known part is where the document holds its shape too', () => {
    const file = ['0 FILE a.ldr', BEAM, '0 FILE 32316.dat', ...SHAPE];
    expect(read(file)).toMatchObject({ parts: [{ part: '32316' }] });
    expect(read(file).guests).toBeUndefined();
  });

  it('are no submodel that only happens to draw a line', () => {
    const file = ['0 FILE a.ldr', `1 4 ${HOME} b.ldr`, '0 FILE b.ldr', '2 24 0 0 0 1 1 1', BEAM];
    expect(read(file).parts).toHaveLength(1);
  });

  it('end in a box where they hold themselves', () => {
    const circle = ['0 FILE c.dat', `1 16 ${HOME} c.dat`, '3 16 0 0 0 20 0 0 0 40 0'];
    const { guests } = read(['0 FILE a.ldr', BEAM, `1 4 ${HOME} c.dat`, ...circle]);
    expect(guests?.kinds[0]?.faces.length).toBeLessThan(9 * 100);
  });

  it('go with the model into files that count parts', () => {
    const json = readMpd([BEAM, `1 4 ${HOME} 3001.dat`].join('\n'), catalogue);
    const file = JSON.parse(withGuestsAsParts(json.ok ? json.value : '')) as Record<
      string,
      unknown
    >;
    expect(file['parts']).toHaveLength(2);
    expect(file['guests']).toBeUndefined();
  });

  it.each([
    [{ kinds: [], parts: [{}] }],
    [{ kinds: [{ id: 'x', name: 'x', min: [1, 0, 0], max: [0, 0, 0] }], parts: [] }],
    [{ kinds: [{ id: 'x', name: 'x', min: [0, 0, 0], max: [1, 1, 1], faces: [1] }], parts: [] }],
    ['guests'],
  ])('are left out of a model file that says of them: %j', (guests) => {
    const model = { format: 'liftarm-model', version: 1, name: '', parts: [], guests };
    const found = readModel(JSON.stringify(model));
    expect(found.ok ? (found.value.guests?.count ?? 0) : -1).toBeLessThanOrEqual(0);
  });
});
