import type { Vec3 } from '../../../../web/src/geometry/vec.ts';
import { cross, distance, dot, subtract } from '../../../../web/src/geometry/vec.ts';
import type { BrickMesh } from '../../../../web/src/view/bricks/mesh-builder.ts';
import { rayMeetsTriangle } from '../../../../web/src/view/part-picking.ts';

type Triangle = readonly [Vec3, Vec3, Vec3];

/** The corners of all triangles. */
export function triangles(mesh: BrickMesh): Triangle[] {
  const at = (corner: number): Vec3 => {
    const i = (mesh.indices[corner] ?? 0) * 3;
    return [mesh.positions[i] ?? 0, mesh.positions[i + 1] ?? 0, mesh.positions[i + 2] ?? 0];
  };
  return Array.from({ length: mesh.indices.length / 3 }, (_, t) => [
    at(3 * t),
    at(3 * t + 1),
    at(3 * t + 2),
  ]);
}

/** Volume within a closed surface whose faces look outwards, cubic modules. */
export function volume(mesh: BrickMesh): number {
  return triangles(mesh).reduce((sum, [a, b, c]) => sum + dot(a, cross(b, c)) / 6, 0);
}

/** Edges that are not walked as often one way as the other: none on closed surfaces. */
export function openEdges(mesh: BrickMesh): number {
  return openEdgesOf(triangles(mesh));
}

/** As openEdges(), of triangles in any unit; corners nearer than 1/10000 of it are one. */
export function openEdgesOf(faces: readonly Triangle[]): number {
  const balance = new Map<string, number>();
  const key = (p: Vec3): string => p.map((value) => Math.round(value * 1e4) + 0).join(',');
  for (const [a, b, c] of faces) {
    for (const [p, q] of [
      [a, b],
      [b, c],
      [c, a],
    ] as const) {
      const from = key(p);
      const to = key(q);
      const forward = from < to;
      const name = forward ? `${from}|${to}` : `${to}|${from}`;
      balance.set(name, (balance.get(name) ?? 0) + (forward ? 1 : -1));
    }
  }
  return [...balance.values()].filter((sum) => sum !== 0).length;
}

/** Length of the shortest side of a triangle. */
export function smallestSide(mesh: BrickMesh): number {
  return triangles(mesh).reduce(
    (least, [a, b, c]) => Math.min(least, distance(a, b), distance(b, c), distance(c, a)),
    Infinity,
  );
}

/** Distance to the first face that a ray meets from its front, or Infinity. */
export function firstHit(mesh: BrickMesh, origin: Vec3, direction: Vec3): number {
  const ray = { origin, direction };
  return triangles(mesh).reduce((best, triangle) => {
    const t = rayMeetsTriangle(ray, triangle);
    return t !== null && t < best ? t : best;
  }, Infinity);
}

/** The box round all vertices. */
export function meshBounds(mesh: BrickMesh): { min: Vec3; max: Vec3 } {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  mesh.positions.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3] ?? value, value);
    high[i % 3] = Math.max(high[i % 3] ?? value, value);
  });
  return { min: toVec(low), max: toVec(high) };
}

function toVec(values: readonly number[]): Vec3 {
  return [values[0] ?? 0, values[1] ?? 0, values[2] ?? 0];
}

/** The largest difference between two points in any coordinate. */
export function largestDifference(a: Vec3, b: Vec3): number {
  return Math.max(...subtract(a, b).map(Math.abs));
}
