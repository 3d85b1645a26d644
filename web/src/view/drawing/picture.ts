import { edgeHex } from '../../model/colours.ts';
import type { DetailName } from '../bricks/detail.ts';
import { type DepthBuffer, drawDepth } from './depth-buffer.ts';
import { type DrawingCamera, enlarged } from './drawing-camera.ts';
import type { DrawnPart, MeshShelf } from './drawn-part.ts';
import { type VisibleLine, visibleLines } from './visible-lines.ts';

/** Pixels, row by row from the top, four bytes each: red, green, blue, alpha. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray<ArrayBuffer>;
}

export interface PictureStyle {
  readonly detail: DetailName;
  /** Pixels of the buffer for one of the picture, along each side: smooths edges. */
  readonly smooth: 1 | 2 | 3;
  /** Width of drawn edges, pixels of the picture. */
  readonly line: number;
  /** Colour and width of the outline of parts that ask for it. */
  readonly outline?: { readonly hex: number; readonly width: number };
}

export const PICTURE_STYLE: PictureStyle = {
  detail: 'high',
  smooth: 2,
  line: 0.5,
  outline: { hex: 0xff7a00, width: 2 },
};

/** A picture of parts on a transparent ground, drawn without a graphics card. */
export function drawPicture(
  parts: readonly DrawnPart[],
  camera: DrawingCamera,
  shelf: MeshShelf,
  style: PictureStyle = PICTURE_STYLE,
): Picture {
  const big = enlarged(camera, style.smooth);
  const buffer = drawDepth(parts, big, shelf, style.detail);
  const pixels = paintSurfaces(parts, buffer);
  const lines = visibleLines(parts, { camera: big, buffer }, shelf, style.detail);
  for (const line of lines) {
    strokeLine(pixels, line, style.line * style.smooth, edgeHex(parts[line.part]?.hex ?? 0));
  }
  if (style.outline) {
    strokeOutline(parts, buffer, pixels, {
      hex: style.outline.hex,
      width: style.outline.width * style.smooth,
    });
  }
  return reduce(pixels, style.smooth);
}

function paintSurfaces(parts: readonly DrawnPart[], buffer: DepthBuffer): Picture {
  const data = new Uint8ClampedArray(buffer.width * buffer.height * 4);
  for (let i = 0; i < buffer.owner.length; i++) {
    const owner = buffer.owner[i] ?? -1;
    if (owner >= 0) {
      put(data, i, parts[owner]?.hex ?? 0, buffer.light[i] ?? 1);
    }
  }
  return { width: buffer.width, height: buffer.height, data };
}

function put(data: Uint8ClampedArray, pixel: number, hex: number, light: number): void {
  // Light above 1 goes towards white, as a shine on plastic.
  const shine = Math.max(0, light - 1) * 255;
  const dim = Math.min(1, light);
  data[4 * pixel] = ((hex >> 16) & 0xff) * dim + shine;
  data[4 * pixel + 1] = ((hex >> 8) & 0xff) * dim + shine;
  data[4 * pixel + 2] = (hex & 0xff) * dim + shine;
  data[4 * pixel + 3] = 255;
}

function strokeLine(picture: Picture, line: VisibleLine, width: number, hex: number): void {
  const steps = Math.max(1, Math.ceil(Math.hypot(line.x2 - line.x1, line.y2 - line.y1)));
  const low = -Math.floor((width - 1) / 2);
  const high = Math.floor(width / 2);
  for (let i = 0; i <= steps; i++) {
    const x = Math.floor(line.x1 + ((line.x2 - line.x1) * i) / steps);
    const y = Math.floor(line.y1 + ((line.y2 - line.y1) * i) / steps);
    for (let dy = low; dy <= high; dy++) {
      for (let dx = low; dx <= high; dx++) {
        putInside(picture, x + dx, y + dy, hex);
      }
    }
  }
}

function putInside(picture: Picture, x: number, y: number, hex: number): void {
  if (x >= 0 && y >= 0 && x < picture.width && y < picture.height) {
    put(picture.data, y * picture.width + x, hex, 1);
  }
}

/** Draws round each group of parts where it borders on something else. */
function strokeOutline(
  parts: readonly DrawnPart[],
  buffer: DepthBuffer,
  picture: Picture,
  pen: { readonly hex: number; readonly width: number },
): void {
  if (!parts.some((part) => part.outline)) {
    return;
  }
  const { width, height, owner } = buffer;
  const groupAt = (i: number) => parts[owner[i] ?? -1]?.outline ?? 0;
  const half = Math.max(1, Math.round(pen.width / 2));
  for (let y = 1; y < height - 1; y++) {
    for (let x = 1; x < width - 1; x++) {
      const i = y * width + x;
      const group = groupAt(i);
      if (group !== groupAt(i + 1) || group !== groupAt(i + width)) {
        strokeDot(picture, x, y, { half, hex: pen.hex });
      }
    }
  }
}

function strokeDot(
  picture: Picture,
  x: number,
  y: number,
  pen: { readonly half: number; readonly hex: number },
): void {
  for (let dy = -pen.half; dy <= pen.half; dy++) {
    for (let dx = -pen.half; dx <= pen.half; dx++) {
      if (dx * dx + dy * dy <= pen.half * pen.half) {
        putInside(picture, x + dx, y + dy, pen.hex);
      }
    }
  }
}

/** Averages squares of `factor` pixels; colours count as much as they are opaque. */
function reduce(picture: Picture, factor: number): Picture {
  if (factor === 1) {
    return picture;
  }
  const width = Math.floor(picture.width / factor);
  const height = Math.floor(picture.height / factor);
  const data = new Uint8ClampedArray(width * height * 4);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      data.set(average(picture, x * factor, y * factor, factor), 4 * (y * width + x));
    }
  }
  return { width, height, data };
}

/** The mean colour of a square of pixels. */
function average(picture: Picture, x0: number, y0: number, side: number): number[] {
  let [red, green, blue, opaque] = [0, 0, 0, 0];
  for (let k = 0; k < side * side; k++) {
    const at = 4 * ((y0 + Math.floor(k / side)) * picture.width + x0 + (k % side));
    const alpha = picture.data[at + 3] ?? 0;
    red += (picture.data[at] ?? 0) * alpha;
    green += (picture.data[at + 1] ?? 0) * alpha;
    blue += (picture.data[at + 2] ?? 0) * alpha;
    opaque += alpha;
  }
  const share = opaque > 0 ? 1 / opaque : 0;
  return [red * share, green * share, blue * share, opaque / (side * side)];
}
