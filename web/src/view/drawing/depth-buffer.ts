import { dot, type Mat3, rotate, type Vec3 } from '../../model/vec.ts';
import type { DetailName } from '../bricks/detail.ts';
import type { BrickMesh } from '../bricks/mesh-builder.ts';
import type { DrawingCamera } from './drawing-camera.ts';
import type { DrawnPart, MeshShelf } from './drawn-part.ts';

/** Lights of the pictures: a key light from above the viewer's left shoulder, and the sky. */
const KEY = { right: -0.45, up: 0.68, out: 0.58, strength: 0.42 } as const;
const AMBIENT = 0.68;
const SKY = 0.08;

/** What covers each pixel: how near it is, which part, and how brightly it is lit. */
export interface DepthBuffer {
  readonly width: number;
  readonly height: number;
  /** Modules towards the eye; -Infinity where nothing is. */
  readonly depth: Float32Array;
  /** Index into the parts that were drawn; -1 where nothing is. */
  readonly owner: Int32Array;
  /** 0 to about 1.2. */
  readonly light: Float32Array;
}

/** Vertices of one part on the picture: x, y, depth, light for each. */
interface Screen {
  readonly values: Float32Array;
}

/** Draws the surfaces of parts into a buffer, without a graphics card. Parts unknown are left out. */
export function drawDepth(
  parts: readonly DrawnPart[],
  camera: DrawingCamera,
  shelf: MeshShelf,
  detail: DetailName,
): DepthBuffer {
  const size = camera.width * camera.height;
  const buffer: DepthBuffer = {
    width: camera.width,
    height: camera.height,
    depth: new Float32Array(size).fill(-Infinity),
    owner: new Int32Array(size).fill(-1),
    light: new Float32Array(size),
  };
  parts.forEach((part, index) => {
    const mesh = shelf.get(part.part, detail);
    if (mesh) {
      const screen = toScreen(mesh, part, camera);
      const { indices } = mesh;
      for (let i = 0; i < indices.length; i += 3) {
        const corners = [indices[i] ?? 0, indices[i + 1] ?? 0, indices[i + 2] ?? 0] as const;
        fillTriangle(buffer, screen.values, corners, index);
      }
    }
  });
  return buffer;
}

/** Rows of the camera's axes in a part's own frame, so that vertices need one product each. */
export function cameraInPart(camera: DrawingCamera, rotation: Mat3): readonly [Vec3, Vec3, Vec3] {
  const back = (v: Vec3): Vec3 =>
    rotate(
      [
        rotation[0],
        rotation[3],
        rotation[6],
        rotation[1],
        rotation[4],
        rotation[7],
        rotation[2],
        rotation[5],
        rotation[8],
      ],
      v,
    );
  return [back(camera.right), back(camera.up), back(camera.out)];
}

function toScreen(mesh: BrickMesh, part: DrawnPart, camera: DrawingCamera): Screen {
  const [right, up, out] = cameraInPart(camera, part.rotation);
  const x0 = camera.originX + camera.scale * dot(part.position, camera.right);
  const y0 = camera.originY - camera.scale * dot(part.position, camera.up);
  const z0 = dot(part.position, camera.out);
  const { positions, normals, shades } = mesh;
  const values = new Float32Array(shades.length * 4);
  for (let i = 0; i < shades.length; i++) {
    const px = positions[3 * i] ?? 0;
    const py = positions[3 * i + 1] ?? 0;
    const pz = positions[3 * i + 2] ?? 0;
    const nx = normals[3 * i] ?? 0;
    const ny = normals[3 * i + 1] ?? 0;
    const nz = normals[3 * i + 2] ?? 0;
    const facing = [right, up, out].map((axis) => axis[0] * nx + axis[1] * ny + axis[2] * nz);
    const key =
      KEY.right * (facing[0] ?? 0) + KEY.up * (facing[1] ?? 0) + KEY.out * (facing[2] ?? 0);
    const light = AMBIENT + SKY * (facing[1] ?? 0) + KEY.strength * Math.max(0, key);
    values[4 * i] = x0 + camera.scale * (right[0] * px + right[1] * py + right[2] * pz);
    values[4 * i + 1] = y0 - camera.scale * (up[0] * px + up[1] * py + up[2] * pz);
    values[4 * i + 2] = z0 + out[0] * px + out[1] * py + out[2] * pz;
    values[4 * i + 3] = light * (0.62 + 0.38 * (shades[i] ?? 1));
  }
  return { values };
}

/** Fills a triangle row by row; what is nearer than what is there already stays. */
function fillTriangle(
  buffer: DepthBuffer,
  v: Float32Array,
  [a, b, c]: readonly [number, number, number],
  owner: number,
): void {
  const ax = v[4 * a] ?? 0;
  const ay = v[4 * a + 1] ?? 0;
  const bx = v[4 * b] ?? 0;
  const by = v[4 * b + 1] ?? 0;
  const cx = v[4 * c] ?? 0;
  const cy = v[4 * c + 1] ?? 0;
  const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  // Counter-clockwise from outside is clockwise on a picture whose y grows downwards.
  if (area >= 0 || !Number.isFinite(area)) {
    return;
  }
  const { width, height, depth, light } = buffer;
  const y0 = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5));
  const y1 = Math.min(height - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
  const x0 = Math.max(0, Math.ceil(Math.min(ax, bx, cx) - 0.5));
  const x1 = Math.min(width - 1, Math.floor(Math.max(ax, bx, cx) - 0.5));
  const az = v[4 * a + 2] ?? 0;
  const bz = v[4 * b + 2] ?? 0;
  const cz = v[4 * c + 2] ?? 0;
  const al = v[4 * a + 3] ?? 0;
  const bl = v[4 * b + 3] ?? 0;
  const cl = v[4 * c + 3] ?? 0;
  for (let y = y0; y <= y1; y++) {
    const py = y + 0.5;
    for (let x = x0; x <= x1; x++) {
      const px = x + 0.5;
      const wa = ((bx - px) * (cy - py) - (cx - px) * (by - py)) / area;
      const wb = ((cx - px) * (ay - py) - (ax - px) * (cy - py)) / area;
      const wc = 1 - wa - wb;
      if (wa >= 0 && wb >= 0 && wc >= 0) {
        const z = wa * az + wb * bz + wc * cz;
        const at = y * width + x;
        if (z > (depth[at] ?? 0)) {
          depth[at] = z;
          buffer.owner[at] = owner;
          light[at] = wa * al + wb * bl + wc * cl;
        }
      }
    }
  }
}
