import { add, cross, dot, normalize, scale, type Vec3 } from '../../geometry/vec.ts';

/** An orthographic camera for pictures: parallel lines stay parallel, as in printed instructions. */
export interface DrawingCamera {
  /** Unit vectors: to the right of the picture, up in it, and out of it towards the eye. */
  readonly right: Vec3;
  readonly up: Vec3;
  readonly out: Vec3;
  /** Pixels for a module. */
  readonly scale: number;
  /** Where the origin of space falls, pixels from the top left corner. */
  readonly originX: number;
  readonly originY: number;
  readonly width: number;
  readonly height: number;
}

export interface PictureSize {
  readonly width: number;
  readonly height: number;
  /** Free pixels on each side. */
  readonly margin?: number;
  /** Never more pixels for a module than this: small things are not blown up. */
  readonly maxScale?: number;
}

/** Out of the picture towards the eye: from the front right, above; what the page calls `iso`. */
export const ISO_OUT: Vec3 = normalize([-0.62, -0.78, 0.62]);

/** A camera that sees all points. @param out from the picture towards the eye, any length. */
export function cameraFor(points: readonly Vec3[], out: Vec3, size: PictureSize): DrawingCamera {
  const axes = axesFor(out);
  const box = { x0: Infinity, x1: -Infinity, y0: Infinity, y1: -Infinity };
  for (const p of points) {
    const x = dot(p, axes.right);
    const y = dot(p, axes.up);
    box.x0 = Math.min(box.x0, x);
    box.x1 = Math.max(box.x1, x);
    box.y0 = Math.min(box.y0, y);
    box.y1 = Math.max(box.y1, y);
  }
  if (!Number.isFinite(box.x0)) {
    Object.assign(box, { x0: -1, x1: 1, y0: -1, y1: 1 });
  }
  const margin = size.margin ?? 0;
  const pixels = Math.min(
    (size.width - 2 * margin) / Math.max(1e-6, box.x1 - box.x0),
    (size.height - 2 * margin) / Math.max(1e-6, box.y1 - box.y0),
    size.maxScale ?? Infinity,
  );
  return {
    ...axes,
    scale: pixels,
    originX: size.width / 2 - (pixels * (box.x0 + box.x1)) / 2,
    originY: size.height / 2 + (pixels * (box.y0 + box.y1)) / 2,
    width: size.width,
    height: size.height,
  };
}

function axesFor(out: Vec3): Pick<DrawingCamera, 'right' | 'up' | 'out'> {
  const back = normalize(out);
  const steep = Math.abs(back[2]) > 0.999;
  const right = normalize(cross(steep ? [0, 1, 0] : [0, 0, 1], back));
  return { right, up: cross(back, right), out: back };
}

/** Where a point falls: pixels from the top left corner, and modules towards the eye. */
export function projectPoint(camera: DrawingCamera, p: Vec3): Vec3 {
  return [
    camera.originX + camera.scale * dot(p, camera.right),
    camera.originY - camera.scale * dot(p, camera.up),
    dot(p, camera.out),
  ];
}

/** The same view with `factor` times the pixels. */
export function enlarged(camera: DrawingCamera, factor: number): DrawingCamera {
  return {
    ...camera,
    scale: camera.scale * factor,
    originX: camera.originX * factor,
    originY: camera.originY * factor,
    width: Math.round(camera.width * factor),
    height: Math.round(camera.height * factor),
  };
}

/** The direction towards the eye after a turn: radians to the right, and upwards. */
export function turned(out: Vec3, azimuth: number, elevation: number): Vec3 {
  const level = Math.hypot(out[0], out[1]);
  const angle = Math.atan2(out[1], out[0]) + azimuth;
  const height = Math.min(1.45, Math.max(-1.45, Math.atan2(out[2], level) + elevation));
  return add(scale([Math.cos(angle), Math.sin(angle), 0], Math.cos(height)), [
    0,
    0,
    Math.sin(height),
  ]);
}
