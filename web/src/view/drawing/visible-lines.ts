import { dot, type Vec3 } from '../../geometry/vec.ts';
import type { DetailName } from '../bricks/detail.ts';
import { cameraInPart, type DepthBuffer } from './depth-buffer.ts';
import type { DrawingCamera } from './drawing-camera.ts';
import type { DrawnPart, MeshShelf } from './drawn-part.ts';

/** A straight stretch of an edge that nothing hides; pixels. */
export interface VisibleLine {
  readonly x1: number;
  readonly y1: number;
  readonly x2: number;
  readonly y2: number;
  /** Index into the parts that were drawn. */
  readonly part: number;
}

/** A line lies on the surfaces that it bounds: this much nearer it is taken to be, modules. */
const LIFT = 0.045;

/** The edges and outlines of parts, cut to what the depth buffer leaves in sight. */
export function visibleLines(
  parts: readonly DrawnPart[],
  scene: { readonly camera: DrawingCamera; readonly buffer: DepthBuffer },
  shelf: MeshShelf,
  detail: DetailName,
): VisibleLine[] {
  const { camera, buffer } = scene;
  const lines: VisibleLine[] = [];
  parts.forEach((part, index) => {
    const mesh = shelf.get(part.part, detail);
    if (!mesh) {
      return;
    }
    const [right, up, out] = cameraInPart(camera, part.rotation);
    const x0 = camera.originX + camera.scale * dot(part.position, camera.right);
    const y0 = camera.originY - camera.scale * dot(part.position, camera.up);
    const z0 = dot(part.position, camera.out);
    const at = (from: Float32Array, i: number): Vec3 => [
      from[3 * i] ?? 0,
      from[3 * i + 1] ?? 0,
      from[3 * i + 2] ?? 0,
    ];
    const onScreen = (p: Vec3): Vec3 => [
      x0 + camera.scale * dot(right, p),
      y0 - camera.scale * dot(up, p),
      z0 + dot(out, p),
    ];
    const { linePositions, lineNormals1, lineNormals2 } = mesh;
    for (let i = 0; i < linePositions.length / 3; i += 2) {
      // Between a face towards the eye and one away from it; zero normals: always drawn.
      if (dot(out, at(lineNormals1, i)) * dot(out, at(lineNormals2, i)) <= 0) {
        const ends = [onScreen(at(linePositions, i)), onScreen(at(linePositions, i + 1))] as const;
        cutLine(lines, buffer, ends, index);
      }
    }
  });
  return lines;
}

function cutLine(
  lines: VisibleLine[],
  buffer: DepthBuffer,
  [a, b]: readonly [Vec3, Vec3],
  part: number,
): void {
  const steps = Math.max(1, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1])));
  let start = -1;
  for (let i = 0; i <= steps + 1; i++) {
    const t = i / steps;
    const shown = i <= steps && isNear(buffer, a, b, t);
    if (shown && start < 0) {
      start = i;
    } else if (!shown && start >= 0) {
      // One sample alone is noise, unless the whole edge is that short.
      if (i - 1 > start || steps === 1) {
        lines.push(stretch(a, b, [start / steps, Math.min(1, (i - 1) / steps)], part));
      }
      start = -1;
    }
  }
}

function stretch(a: Vec3, b: Vec3, [s, t]: readonly [number, number], part: number): VisibleLine {
  return {
    x1: a[0] + (b[0] - a[0]) * s,
    y1: a[1] + (b[1] - a[1]) * s,
    x2: a[0] + (b[0] - a[0]) * t,
    y2: a[1] + (b[1] - a[1]) * t,
    part,
  };
}

/** Whether a point of the line is in sight: nearer than the farthest of the pixels around it. */
function isNear(buffer: DepthBuffer, a: Vec3, b: Vec3, t: number): boolean {
  const x = Math.floor(a[0] + (b[0] - a[0]) * t);
  const y = Math.floor(a[1] + (b[1] - a[1]) * t);
  const z = a[2] + (b[2] - a[2]) * t + LIFT;
  const { width, height, depth } = buffer;
  if (x < 0 || y < 0 || x >= width || y >= height) {
    return false;
  }
  const here = y * width + x;
  if (z > (depth[here] ?? 0)) {
    return true;
  }
  const left = x > 0 ? here - 1 : here;
  const right = x < width - 1 ? here + 1 : here;
  const above = y > 0 ? here - width : here;
  const below = y < height - 1 ? here + width : here;
  const farthest = Math.min(
    depth[left] ?? 0,
    depth[right] ?? 0,
    depth[above] ?? 0,
    depth[below] ?? 0,
  );
  return z > farthest;
}
