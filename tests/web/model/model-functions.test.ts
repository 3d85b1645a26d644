import { describe, expect, it } from 'vitest';
import { IDENTITY, type Mat3, type Vec3 } from '../../../web/src/geometry/vec.ts';
import { modelBounds, sketchBounds, unionBounds } from '../../../web/src/model/bounds.ts';
import { readCatalogue } from '../../../web/src/model/catalogue.ts';
import {
  BRICK_COLOURS,
  colourHex,
  colourName,
  edgeHex,
  groupHex,
  luminance,
} from '../../../web/src/model/colours.ts';
import { countClasses, countParts, modelMass } from '../../../web/src/model/counts.ts';
import type { Model, PlacedPart } from '../../../web/src/model/model.ts';
import { emptySketch, lineNodes, sketchNodes } from '../../../web/src/model/sketch.ts';
import { catalogue } from '../view/helpers/catalogue.ts';

const QUARTER_TURN_ABOUT_Z: Mat3 = [0, -1, 0, 1, 0, 0, 0, 0, 1];

function placed(part: string, color: number, rest: Partial<PlacedPart> = {}): PlacedPart {
  const common = { position: [0, 0, 0] as Vec3, rotation: IDENTITY };
  return { part, color, component: 0, layer: 0, piece: 0, ...common, ...rest };
}

describe('colours', () => {
  it('finds a colour by its code', () => {
    expect(colourName(4)).toBe('Red');
    expect(colourHex(4)).toBe(0xb40000);
  });

  it('draws an unknown code as light bluish grey and says its number', () => {
    expect(colourHex(4711)).toBe(colourHex(71));
    expect(colourName(4711)).toBe('Colour 4711');
  });

  it('has each code once', () => {
    expect(new Set(BRICK_COLOURS.map((colour) => colour.code)).size).toBe(BRICK_COLOURS.length);
  });

  it('knows the colour of every part in the catalogue', () => {
    const known = new Set(BRICK_COLOURS.map((colour) => colour.code));
    expect(catalogue.parts.filter((part) => !known.has(part.color))).toEqual([]);
  });

  it('draws lighter edges on black and darker ones on white', () => {
    expect(luminance(edgeHex(colourHex(0)))).toBeGreaterThan(luminance(colourHex(0)));
    expect(luminance(edgeHex(colourHex(15)))).toBeLessThan(luminance(colourHex(15)));
  });

  it('gives neighbouring groups different colours and none a grey', () => {
    expect(groupHex(0)).not.toBe(groupHex(1));
    expect(groupHex(-1)).not.toBe(groupHex(0));
  });
});

describe('counts', () => {
  const model: Model = {
    name: 'counts',
    parts: [placed('2780', 0), placed('32316', 4), placed('2780', 0), placed('2780', 1)],
  };

  it('counts by part and colour, most frequent first', () => {
    expect(countParts(model)).toEqual([
      { part: '2780', color: 0, count: 2 },
      { part: '2780', color: 1, count: 1 },
      { part: '32316', color: 4, count: 1 },
    ]);
  });

  it('counts by class', () => {
    expect(countClasses(model, catalogue).get('pin')).toBe(3);
    expect(countClasses(model, catalogue).get('beam')).toBe(1);
  });

  it('adds up masses', () => {
    const beam = catalogue.find('32316')?.mass ?? 0;
    const pin = catalogue.find('2780')?.mass ?? 0;
    expect(modelMass(model, catalogue)).toBeCloseTo(beam + 3 * pin, 9);
  });
});

describe('bounds', () => {
  it('turns and shifts a part with its box', () => {
    const parts = [placed('32316', 4, { position: [10, 0, 0], rotation: QUARTER_TURN_ABOUT_Z })];
    const box = modelBounds({ name: '', parts }, catalogue);
    expect(box?.min.map((value) => Number(value.toFixed(6)))).toEqual([7.55, -0.45, -0.5]);
    expect(box?.max.map((value) => Number(value.toFixed(6)))).toEqual([12.45, 0.45, 0.5]);
  });

  it('is null without anything', () => {
    expect(modelBounds({ name: '', parts: [] }, catalogue)).toBeNull();
    expect(sketchBounds(emptySketch())).toBeNull();
    expect(unionBounds(null, null)).toBeNull();
  });
});

describe('sketch nodes', () => {
  it('stand at unit spacing, ends included', () => {
    expect(lineNodes({ from: [0, 0, 0], to: [3, 0, 0] })).toEqual([
      [0, 0, 0],
      [1, 0, 0],
      [2, 0, 0],
      [3, 0, 0],
    ]);
  });

  it('are junctions where lines meet or cross, and ends where one line ends', () => {
    const nodes = sketchNodes([
      { from: [0, 0, 0], to: [4, 0, 0] },
      { from: [2, -1, 0], to: [2, 1, 0] },
    ]);
    const kindAt = (at: Vec3): string | undefined =>
      nodes.find((node) => node.at.every((value, i) => value === at[i]))?.kind;
    expect(nodes).toHaveLength(7);
    expect(kindAt([2, 0, 0])).toBe('junction');
    expect(kindAt([4, 0, 0])).toBe('end');
    expect(kindAt([1, 0, 0])).toBe('inner');
  });

  it('meet at points that are no integers', () => {
    const tip: Vec3 = [2, 2 * Math.sqrt(3), 0];
    const nodes = sketchNodes([
      { from: [0, 0, 0], to: tip },
      { from: [4, 0, 0], to: [2.0000001, 3.4641016, 0] },
    ]);
    expect(nodes.filter((node) => node.kind === 'junction')).toHaveLength(1);
  });
});

describe('readCatalogue', () => {
  it('refuses what is no catalogue', () => {
    expect(() => readCatalogue({ parts: [] })).toThrow('catalogue');
  });
});
