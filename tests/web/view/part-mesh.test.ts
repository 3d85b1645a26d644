import { describe, expect, it } from 'vitest';
import { add, cross, normalize, scale, type Vec3 } from '../../../web/src/geometry/vec.ts';
import { isHole } from '../../../web/src/model/catalogue.ts';
import { DETAILS, type DetailName } from '../../../web/src/view/bricks/detail.ts';
import type { BrickMesh } from '../../../web/src/view/bricks/mesh-builder.ts';
import { buildPartMesh } from '../../../web/src/view/bricks/part-mesh.ts';
import { catalogue, partOf } from './helpers/catalogue.ts';
import {
  firstHit,
  largestDifference,
  meshBounds,
  openEdges,
  smallestSide,
  volume,
} from './helpers/mesh-facts.ts';

const DETAIL_NAMES = Object.keys(DETAILS) as DetailName[];
const STRAIGHT_BEAMS = ['18654', '43857', '32523', '32316', '32524', '40490', '32278', '32449'];

function everyMesh(check: (mesh: BrickMesh, name: string) => void): void {
  for (const part of catalogue.parts) {
    for (const detail of DETAIL_NAMES) {
      check(buildPartMesh(part, detail), `${part.id} ${detail}`);
    }
  }
}

/** A direction across an axis that lies in no symmetry plane of a cross or a slot. */
function askew(axis: Vec3): Vec3 {
  const hint: Vec3 = Math.abs(axis[0]) < 0.9 ? [1, 0.3, 0.2] : [0.2, 1, 0.3];
  return normalize(cross(axis, hint));
}

describe('the mesh of every part', () => {
  it('has finite coordinates', () => {
    everyMesh((mesh, name) => {
      const arrays = [mesh.positions, mesh.normals, mesh.shades, mesh.linePositions];
      for (const values of arrays) {
        expect(values.length, name).toBeGreaterThan(0);
        expect(values.every(Number.isFinite), name).toBe(true);
      }
    });
  });

  it('has normals of unit length', () => {
    everyMesh((mesh, name) => {
      for (let i = 0; i < mesh.normals.length; i += 3) {
        const [x = 0, y = 0, z = 0] = mesh.normals.subarray(i, i + 3);
        if (Math.abs(Math.hypot(x, y, z) - 1) > 1e-4) {
          expect.fail(`${name}: normal ${i / 3} is (${x}, ${y}, ${z})`);
        }
      }
    });
  });

  it('is closed, without triangles that are none', () => {
    everyMesh((mesh, name) => {
      expect(openEdges(mesh), name).toBe(0);
      expect(smallestSide(mesh), name).toBeGreaterThan(1e-4);
      expect(volume(mesh), name).toBeGreaterThan(0.1);
    });
  });

  it('uses only vertices that it has', () => {
    everyMesh((mesh, name) => {
      const last = mesh.indices.reduce((a, b) => Math.max(a, b), 0);
      expect(last, name).toBeLessThan(mesh.positions.length / 3);
    });
  });

  it.each(['ultra', 'high'] as const)('fills the bounds of the catalogue (%s)', (detail) => {
    for (const part of catalogue.parts) {
      const { min, max } = meshBounds(buildPartMesh(part, detail));
      expect(largestDifference(min, part.boundsMin), part.id).toBeLessThan(0.1);
      expect(largestDifference(max, part.boundsMax), part.id).toBeLessThan(0.1);
    }
  });

  it('leaves every hole open at one end at least', () => {
    for (const part of catalogue.parts) {
      const mesh = buildPartMesh(part, 'high');
      for (const hole of part.features.filter((feature) => isHole(feature.kind))) {
        const depths = [1, -1].map((side) => {
          const outward = scale(hole.axis, side);
          const mouth = add(hole.center, scale(outward, hole.length / 2 + 0.3));
          // A little off the middle line, so that the ray passes through no shared edge.
          const start = add(mouth, scale(askew(hole.axis), 0.05));
          return firstHit(mesh, start, scale(outward, -1));
        });
        expect(Math.max(...depths), `${part.id} at ${hole.center}`).toBeGreaterThan(0.55);
      }
    }
  });

  it('costs less at each coarser level', () => {
    for (const part of catalogue.parts.filter((candidate) => candidate.partClass === 'beam')) {
      const sizes = DETAIL_NAMES.map((detail) => buildPartMesh(part, detail).indices.length);
      expect(
        [...sizes].sort((a, b) => b - a),
        part.id,
      ).toEqual(sizes);
    }
  });
});

describe('the mesh of a straight beam', () => {
  it.each(STRAIGHT_BEAMS)('is closed (%s)', (id) => {
    for (const detail of DETAIL_NAMES) {
      expect(openEdges(buildPartMesh(partOf(id), detail)), detail).toBe(0);
    }
  });

  it.each(STRAIGHT_BEAMS)('has as many holes through it as features (%s)', (id) => {
    const part = partOf(id);
    const mesh = buildPartMesh(part, 'high');
    const open = part.features.filter((hole) => {
      const start = add(hole.center, add(scale(hole.axis, 2), scale(askew(hole.axis), 0.05)));
      return firstHit(mesh, start, scale(hole.axis, -1)) === Infinity;
    });
    expect(open).toHaveLength(part.features.length);
  });

  it('encloses the volume of a stadium less its holes', () => {
    const hole = Math.PI * (0.305 ** 2 * 0.8 + 0.4 ** 2 * 0.2);
    const expected = 4 * 0.9 + Math.PI * 0.45 ** 2 - 5 * hole;
    expect(volume(buildPartMesh(partOf('32316'), 'ultra'))).toBeCloseTo(expected, 1);
  });
});

describe('the mesh of a gear', () => {
  it.each(['32270', '94925', '3648b', '3649'])('is closed and has its teeth (%s)', (id) => {
    const part = partOf(id);
    const mesh = buildPartMesh(part, 'high');
    expect(openEdges(mesh)).toBe(0);
    const tips = new Set<string>();
    for (let i = 0; i < mesh.positions.length; i += 3) {
      const [x = 0, , z = 0] = mesh.positions.subarray(i, i + 3);
      if (Math.hypot(x, z) > (part.solid[0]?.radius ?? 0) - 1e-3) {
        tips.add(`${x.toFixed(3)},${z.toFixed(3)}`);
      }
    }
    expect(tips.size).toBe(2 * Number(/(\d+) Tooth/.exec(part.name)?.[1]));
  });
});

describe('the mesh of an axle', () => {
  it.each(['3704', '3705', '3708'])('is closed and looks outwards (%s)', (id) => {
    const mesh = buildPartMesh(partOf(id), 'high');
    expect(openEdges(mesh)).toBe(0);
    expect(volume(mesh)).toBeGreaterThan(0);
  });
});
