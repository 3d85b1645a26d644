import { add, cross, normalize, rotate, scale, subtract, type Vec3 } from '../../geometry/vec.ts';
import type { Model } from '../../model/model.ts';
import type { MeshShelf } from '../drawing/drawn-part.ts';
import { type WeldedMesh, weld } from './weld.ts';

const MM_PER_MODULE = 8;
const HEADER = 80;
const RECORD = 50;

/**
 * The model's surfaces as a binary STL file: millimetres, Z up, all parts in one shell each. Faces that meet
 * have the same bytes for the corners that they share, since programs that slice compare exactly.
 * Parts that the catalogue does not know are left out.
 */
export function writeStl(model: Model, shelf: MeshShelf): Uint8Array<ArrayBuffer> {
  const meshes = new Map<string, WeldedMesh>();
  const meshOf = (part: string): WeldedMesh | undefined => {
    const mesh = meshes.has(part) ? undefined : shelf.get(part, 'high');
    if (mesh) {
      meshes.set(part, weld(mesh.positions, mesh.indices));
    }
    return meshes.get(part);
  };
  const placed = model.parts.flatMap((part) => {
    const mesh = meshOf(part.part);
    if (!mesh) {
      return [];
    }
    const points = mesh.points.map((own) =>
      scale(add(rotate(part.rotation, own), part.position), MM_PER_MODULE).map(single),
    ) as unknown as Vec3[];
    return [facesOf(points, mesh)];
  });
  const count = placed.reduce((sum, faces) => sum + faces.length, 0);
  const file = new Uint8Array(HEADER + 4 + count * RECORD);
  file.set(new TextEncoder().encode('Liftarm, millimetres, Z up').subarray(0, HEADER));
  const view = new DataView(file.buffer);
  view.setUint32(HEADER, count, true);
  let at = HEADER + 4;
  for (const [a, b, c] of placed.flat()) {
    const normal = normalize(cross(subtract(b, a), subtract(c, a)));
    [...normal, ...a, ...b, ...c].forEach((value, k) => {
      view.setFloat32(at + 4 * k, value, true);
    });
    at += RECORD;
  }
  return file;
}

/** As the file holds it; there is one 0, since readers compare bytes. */
function single(value: number): number {
  return Math.fround(value) + 0;
}

function facesOf(points: readonly Vec3[], mesh: WeldedMesh): (readonly [Vec3, Vec3, Vec3])[] {
  return mesh.faces.map(
    ([a, b, c]) => [points[a] as Vec3, points[b] as Vec3, points[c] as Vec3] as const,
  );
}
