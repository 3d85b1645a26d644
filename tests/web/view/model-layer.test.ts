import { InstancedMesh, LineSegments, type Object3D } from 'three';
import { beforeEach, describe, expect, it } from 'vitest';
import { IDENTITY, type Vec3 } from '../../../web/src/geometry/vec.ts';
import type { Model, PlacedPart } from '../../../web/src/model/model.ts';
import { BrickLibrary } from '../../../web/src/view/bricks/brick-library.ts';
import { BrickMaterials } from '../../../web/src/view/bricks/brick-materials.ts';
import { chooseDetail, TRIANGLE_BUDGET } from '../../../web/src/view/level-of-detail.ts';
import { ModelLayer } from '../../../web/src/view/model-layer.ts';
import { catalogue } from './helpers/catalogue.ts';

function placed(part: string, position: Vec3): PlacedPart {
  return { part, color: 71, position, rotation: IDENTITY, component: 0, layer: 0, piece: 0 };
}

const model: Model = {
  name: 'three kinds',
  parts: [
    placed('32316', [0, 0, 0]),
    placed('2780', [0, 0, 0.5]),
    placed('32316', [0, 0, 1]),
    placed('no such part', [0, 0, 0]),
    placed('55615', [4, 0, 0]),
  ],
};

function surfaces(layer: ModelLayer): InstancedMesh[] {
  return layer.group.children.filter((child: Object3D) => child instanceof InstancedMesh);
}

function instances(layer: ModelLayer): number {
  return surfaces(layer).reduce((sum, mesh) => sum + mesh.count, 0);
}

describe('ModelLayer', () => {
  let layer: ModelLayer;

  beforeEach(() => {
    layer = new ModelLayer(new BrickLibrary(catalogue), new BrickMaterials());
    layer.setModel(model);
  });

  it('draws every known part once', () => {
    expect(instances(layer)).toBe(4);
  });

  it('takes two draw calls for each kind of part', () => {
    const lines = layer.group.children.filter((child) => child instanceof LineSegments);
    expect(surfaces(layer)).toHaveLength(3);
    expect(lines).toHaveLength(3);
  });

  it('hides the others of an isolated part', () => {
    layer.setIsolation({ parts: new Set([1]), others: 'hidden' });
    expect(instances(layer)).toBe(1);
  });

  it('keeps the others of an isolated part as ghosts', () => {
    layer.setIsolation({ parts: new Set([1]), others: 'ghost' });
    expect(instances(layer)).toBe(4);
  });

  it('moves parts away from the middle when exploded', () => {
    const before = layer.partCentre(4);
    layer.setExplode(1);
    const after = layer.partCentre(4);
    expect((after?.[0] ?? 0) - (before?.[0] ?? 0)).toBeGreaterThan(0.5);
  });

  it('draws nothing that is not built when it goes in slices', () => {
    const patient = new ModelLayer(new BrickLibrary(catalogue), new BrickMaterials(), 'in-slices');
    patient.setModel(model);
    expect(instances(patient)).toBe(0);
    expect(patient.advance(0)).toBe(true);
    expect(surfaces(patient)).toHaveLength(1);
    while (patient.advance(0)) {}
    expect(instances(patient)).toBe(4);
  });

  it('keeps bricks at their level until the new one is built', () => {
    const patient = new ModelLayer(new BrickLibrary(catalogue), new BrickMaterials(), 'in-slices');
    patient.setModel(model);
    patient.advance(Infinity);
    const corners = () => surfaces(patient).map((mesh) => mesh.geometry.index?.count ?? 0);
    const high = corners();
    patient.setDetail('low');
    expect(corners()).toEqual(high);
    patient.advance(Infinity);
    expect(Math.max(...corners())).toBeLessThan(Math.min(...high));
  });

  it('is empty again without a model', () => {
    layer.setModel(null);
    expect(layer.group.children).toHaveLength(0);
    expect(layer.bounds).toBeNull();
  });

  it.each([
    ['beams and pins', ['32524', '2780', '32316', '6558', '2780']],
    ['long beams alone', ['32278']],
    ['connectors alone', ['55615', '48989']],
  ])('stays within the budget with a thousand parts at any size (%s)', (_, mix) => {
    const parts = Array.from({ length: 1000 }, (_unused, i) =>
      placed(mix[i % mix.length] ?? '2780', [i, 0, 0]),
    );
    layer.setModel({ name: 'large', parts });
    for (const pixels of [300, 60, 15, 5]) {
      layer.setDetail(chooseDetail(pixels, (detail) => layer.trianglesAt(detail)).detail);
      const drawn = surfaces(layer).reduce(
        (sum, mesh) => sum + (mesh.count * (mesh.geometry.index?.count ?? 0)) / 3,
        0,
      );
      expect(drawn).toBeLessThanOrEqual(TRIANGLE_BUDGET);
    }
  });
});

describe('chooseDetail', () => {
  const cheap = (): number => 1000;

  it('grows coarser as one moves away', () => {
    const names = [200, 40, 12, 3].map((pixels) => chooseDetail(pixels, cheap).detail);
    expect(names).toEqual(['ultra', 'high', 'medium', 'low']);
  });

  it('takes the finest level that the budget allows', () => {
    const costs = { ultra: 4, high: 2, medium: 1, low: 0.5 };
    const choice = chooseDetail(200, (detail) => costs[detail] * 0.6 * TRIANGLE_BUDGET);
    expect(choice.detail).toBe('medium');
  });

  it('draws a model that no level makes cheap enough at the coarsest', () => {
    expect(chooseDetail(200, () => 10 * TRIANGLE_BUDGET).detail).toBe('low');
  });

  it('draws lines fainter as one moves away', () => {
    const strengths = [60, 20, 8, 3].map((pixels) => chooseDetail(pixels, cheap).lineOpacity);
    expect([...strengths].sort((a, b) => b - a)).toEqual(strengths);
    expect(new Set(strengths).size).toBe(4);
  });

  it('leaves lines out where they would be denser than pixels', () => {
    expect(chooseDetail(3, cheap).lineOpacity).toBe(0);
  });
});
