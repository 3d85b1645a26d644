import { dot, type Mat3, rotate, type Vec3 } from '../../geometry/vec.ts';
import type { DetailName } from '../bricks/detail.ts';
import type { BrickMesh } from '../bricks/mesh-builder.ts';
import type { DrawingCamera } from './drawing-camera.ts';
import type { DrawnPart, MeshShelf } from './drawn-part.ts';

/** Lights of the pictures: a key light from above the viewer's left shoulder, and the sky. */
const KEY = { right: -0.45, up: 0.68, out: 0.58, strength: 0.3 } as const;
const AMBIENT = 0.78;
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

/** A triangle on the picture: what its numbers are at a pixel is `a` plus shares of `b` and `c`. */
interface Slope {
  /** Barycentric weights at x = y = 0 and how they grow to the right and downwards. */
  readonly wb: readonly [number, number, number];
  readonly wc: readonly [number, number, number];
  readonly depth: readonly [number, number, number];
  readonly light: readonly [number, number, number];
  readonly owner: number;
}

/** Fills a triangle row by row; what is nearer than what is there already stays. */
function fillTriangle(
  buffer: DepthBuffer,
  v: Float32Array,
  [a, b, c]: readonly [number, number, number],
  owner: number,
): void {
  const at = (vertex: number, field: number) => v[4 * vertex + field] ?? 0;
  const [ax, bx, cx] = [at(a, 0), at(b, 0), at(c, 0)];
  const [ay, by, cy] = [at(a, 1), at(b, 1), at(c, 1)];
  const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  // Counter-clockwise from outside is clockwise on a picture whose y grows downwards.
  if (area >= 0 || !Number.isFinite(area)) {
    return;
  }
  const slope: Slope = {
    wb: [(cx * ay - ax * cy) / area, (cy - ay) / area, (ax - cx) / area],
    wc: [(ax * by - bx * ay) / area, (ay - by) / area, (bx - ax) / area],
    depth: [at(a, 2), at(b, 2) - at(a, 2), at(c, 2) - at(a, 2)],
    light: [at(a, 3), at(b, 3) - at(a, 3), at(c, 3) - at(a, 3)],
    owner,
  };
  const x0 = Math.max(0, Math.ceil(Math.min(ax, bx, cx) - 0.5));
  const x1 = Math.min(buffer.width - 1, Math.floor(Math.max(ax, bx, cx) - 0.5));
  const y0 = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5));
  const y1 = Math.min(buffer.height - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
  for (let y = y0; y <= y1; y++) {
    fillRow(buffer, slope, y, [x0, x1]);
  }
}

function fillRow(
  buffer: DepthBuffer,
  slope: Slope,
  y: number,
  [x0, x1]: readonly [number, number],
): void {
  const { wb, wc, depth, light } = slope;
  let b = wb[0] + wb[1] * (x0 + 0.5) + wb[2] * (y + 0.5);
  let c = wc[0] + wc[1] * (x0 + 0.5) + wc[2] * (y + 0.5);
  let at = y * buffer.width + x0;
  for (let x = x0; x <= x1; x++, at++, b += wb[1], c += wc[1]) {
    if (b >= 0 && c >= 0 && b + c <= 1) {
      const z = depth[0] + b * depth[1] + c * depth[2];
      if (z > (buffer.depth[at] ?? 0)) {
        buffer.depth[at] = z;
        buffer.owner[at] = slope.owner;
        buffer.light[at] = light[0] + b * light[1] + c * light[2];
      }
    }
  }
}
