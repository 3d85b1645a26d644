import { describe, expect, it } from 'vitest';
import { IDENTITY, ORIGIN, type Vec3 } from '../../../web/src/geometry/vec.ts';
import type { PlacedPart } from '../../../web/src/model/model.ts';
import { sketchNodes } from '../../../web/src/model/sketch.ts';
import { BrickLibrary } from '../../../web/src/view/bricks/brick-library.ts';
import { pickPart, rayEntersBox } from '../../../web/src/view/part-picking.ts';
import { pickLine, pickNode } from '../../../web/src/view/sketch-picking.ts';
import type { Projected } from '../../../web/src/view/view-types.ts';
import { catalogue } from './helpers/catalogue.ts';

const library = new BrickLibrary(catalogue);
const context = { library, shift: () => ORIGIN, isPickable: () => true };
const DOWN: Vec3 = [0, 0, -1];

function beamAt(position: Vec3): PlacedPart {
  return {
    part: '32316',
    color: 4,
    position,
    rotation: IDENTITY,
    component: 0,
    layer: 0,
    piece: 0,
  };
}

/** Looks along -z: x to the right, y up, ten pixels a module. */
function project(point: Vec3): Projected {
  return { x: point[0] * 10, y: -point[1] * 10, visible: true };
}

describe('pickPart', () => {
  const parts = [beamAt([0, 0, 0]), beamAt([0, 0, 3])];

  it('takes the nearer of two parts', () => {
    const pick = pickPart({ origin: [0.42, 0.5, 9], direction: DOWN }, parts, context);
    expect(pick?.index).toBe(1);
    expect(pick?.distance).toBeCloseTo(5.5, 6);
  });

  it('reaches through the holes of the nearer part', () => {
    const behind = [beamAt([0.4, 0.45, 0]), beamAt([0, 0, 3])];
    const pick = pickPart({ origin: [0.04, 0.03, 9], direction: DOWN }, behind, context);
    expect(pick?.index).toBe(0);
  });

  it('leaves out parts that may not be picked', () => {
    const ray = { origin: [0.42, 0.5, 9] as const, direction: DOWN };
    const pick = pickPart(ray, parts, { ...context, isPickable: (index) => index === 0 });
    expect(pick?.index).toBe(0);
  });

  it('follows parts that are moved apart', () => {
    const shift = (index: number): Vec3 => [index * 20, 0, 0];
    const ray = { origin: [20.42, 0.5, 9] as const, direction: DOWN };
    expect(pickPart(ray, parts, { ...context, shift })?.index).toBe(1);
  });

  it('finds nothing beside the parts', () => {
    expect(pickPart({ origin: [5, 5, 9], direction: DOWN }, parts, context)).toBeNull();
  });
});

describe('rayEntersBox', () => {
  it('gives 0 from inside', () => {
    const ray = { origin: ORIGIN, direction: DOWN };
    expect(rayEntersBox(ray, [-1, -1, -1], [1, 1, 1])).toBe(0);
  });

  it('misses a box behind the eye', () => {
    const ray = { origin: [0, 0, -5] as const, direction: DOWN };
    expect(rayEntersBox(ray, [-1, -1, -1], [1, 1, 1])).toBeNull();
  });
});

describe('picking in the sketch', () => {
  const lines = [
    { from: [0, 0, 0] as const, to: [10, 0, 0] as const },
    { from: [0, 2, 0] as const, to: [10, 2, 0] as const },
  ];
  const nodes = sketchNodes(lines);

  it('takes the nearest line within reach', () => {
    expect(pickLine({ x: 55, y: -6 }, lines, project, 8)?.index).toBe(0);
  });

  it('gives the nearest point of the line', () => {
    expect(pickLine({ x: 55, y: 3 }, lines, project, 8)?.point).toEqual([5.5, 0, 0]);
  });

  it('takes no line beyond reach', () => {
    expect(pickLine({ x: 55, y: -10 }, lines, project, 8)).toBeNull();
  });

  it('prefers an end to an inner node that is hardly nearer', () => {
    expect(pickNode({ x: 4, y: 0 }, [...nodes], project, 12)?.at).toEqual([0, 0, 0]);
    expect(pickNode({ x: 5.5, y: 0 }, [...nodes], project, 12)?.at).toEqual([0, 0, 0]);
    expect(pickNode({ x: 8, y: 0 }, [...nodes], project, 12)?.at).toEqual([1, 0, 0]);
  });
});
