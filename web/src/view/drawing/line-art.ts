import { drawDepth } from './depth-buffer.ts';
import { cameraFor, type DrawingCamera } from './drawing-camera.ts';
import type { DrawnPart, MeshShelf } from './drawn-part.ts';
import { visibleLines } from './visible-lines.ts';

/** Longer side of the hidden-line computation, pixels: finer than a printer shows. */
const RESOLUTION = 2400;
const MARGIN = 24;
/** Millimetres for a module: half the real size fits a page. */
const MM_PER_MODULE = 4;

/**
 * The model as line drawing without hidden lines: an SVG text, four millimetres for a module.
 * @param out from the picture towards the eye.
 */
export function writeLineArt(
  parts: readonly DrawnPart[],
  out: DrawingCamera['out'],
  shelf: MeshShelf,
  title: string,
): string {
  const points = parts.flatMap((part) => shelf.corners(part));
  const camera = fitted(points, out);
  const buffer = drawDepth(parts, camera, shelf, 'high');
  const lines = visibleLines(parts, { camera, buffer }, shelf, 'high');
  const path = lines
    .map((line) => `M${px(line.x1)} ${px(line.y1)}L${px(line.x2)} ${px(line.y2)}`)
    .join('');
  const mm = MM_PER_MODULE / camera.scale;
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${camera.width} ${camera.height}" ` +
    `width="${px(camera.width * mm)}mm" height="${px(camera.height * mm)}mm">` +
    `<title>${escapeXml(title)}</title>` +
    `<path d="${path}" fill="none" stroke="#111" stroke-width="2" stroke-linecap="round"/></svg>\n`
  );
}

function fitted(points: Parameters<typeof cameraFor>[0], out: DrawingCamera['out']) {
  const wide = cameraFor(points, out, { width: RESOLUTION, height: RESOLUTION, margin: MARGIN });
  // Cut the empty stripes off: the picture is as high or as wide as the model.
  const seen = points.map((p) => ({
    x: wide.originX + wide.scale * inner(p, wide.right),
    y: wide.originY - wide.scale * inner(p, wide.up),
  }));
  const left = Math.min(...seen.map((p) => p.x)) - MARGIN;
  const top = Math.min(...seen.map((p) => p.y)) - MARGIN;
  const width = Math.ceil(Math.max(...seen.map((p) => p.x)) + MARGIN - left);
  const height = Math.ceil(Math.max(...seen.map((p) => p.y)) + MARGIN - top);
  return { ...wide, originX: wide.originX - left, originY: wide.originY - top, width, height };
}

function inner(a: readonly number[], b: readonly number[]): number {
  return (a[0] ?? 0) * (b[0] ?? 0) + (a[1] ?? 0) * (b[1] ?? 0) + (a[2] ?? 0) * (b[2] ?? 0);
}

function px(value: number): string {
  return String(Math.round(value * 100) / 100);
}

export function escapeXml(text: string): string {
  const names: Record<string, string> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };
  return text.replace(/[&<>"]/g, (c) => names[c] ?? c);
}
