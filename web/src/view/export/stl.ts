import { add, cross, normalize, rotate, scale, subtract, type Vec3 } from '../../geometry/vec.ts';
import type { Model } from '../../model/model.ts';
import type { MeshShelf } from '../drawing/drawn-part.ts';

const MM_PER_MODULE = 8;
const HEADER = 80;
const RECORD = 50;

/**
 * The model's surfaces as a binary STL file: millimetres, Z up, all parts in one shell each.
 * Parts that the catalogue does not know are left out.
 */
export function writeStl(model: Model, shelf: MeshShelf): Uint8Array<ArrayBuffer> {
  const placed = model.parts.flatMap((part) => {
    const mesh = shelf.get(part.part, 'high');
    return mesh ? [{ part, mesh }] : [];
  });
  const count = placed.reduce((sum, { mesh }) => sum + mesh.indices.length / 3, 0);
  const file = new Uint8Array(HEADER + 4 + count * RECORD);
  file.set(new TextEncoder().encode('Liftarm, millimetres, Z up').subarray(0, HEADER));
  const view = new DataView(file.buffer);
  view.setUint32(HEADER, count, true);
  let at = HEADER + 4;
  for (const { part, mesh } of placed) {
    const vertex = (i: number): Vec3 => {
      const k = 3 * (mesh.indices[i] ?? 0);
      const own: Vec3 = [
        mesh.positions[k] ?? 0,
        mesh.positions[k + 1] ?? 0,
        mesh.positions[k + 2] ?? 0,
      ];
      return scale(add(rotate(part.rotation, own), part.position), MM_PER_MODULE);
    };
    for (let i = 0; i < mesh.indices.length; i += 3) {
      const a = vertex(i);
      const b = vertex(i + 1);
      const c = vertex(i + 2);
      const normal = normalize(cross(subtract(b, a), subtract(c, a)));
      [...normal, ...a, ...b, ...c].forEach((value, k) => {
        view.setFloat32(at + 4 * k, value, true);
      });
      at += RECORD;
    }
  }
  return file;
}
