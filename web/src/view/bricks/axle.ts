import { type Detail, DIMENSIONS } from './detail.ts';
import { crossPolygon } from './holes.ts';
import { type Frame, type MeshBuilder, type Point2, toPart } from './mesh-builder.ts';
import { addPolygon } from './plate.ts';

/** Length of the bevel at a free end, modules, and how far it narrows the cross. */
const BEVEL = { length: 0.04, scale: 0.88 } as const;

/** Which ends of an axle are free: those have a bevel. */
export interface AxleEnds {
  readonly low: boolean;
  readonly high: boolean;
}

/**
 * Adds an axle along the frame's z axis from -halfLength to +halfLength; a wing lies along x.
 * Ends that sit in a body are flat and without lines.
 */
export function addAxle(
  builder: MeshBuilder,
  frame: Frame,
  run: { readonly halfLength: number; readonly ends: AxleEnds },
  detail: Detail,
): void {
  const full = crossPolygon(DIMENSIONS.axleRadius, DIMENSIONS.axleWing);
  const polygon = detail.name === 'low' ? full.filter((_, i) => i % 4 !== 1) : full;
  const bevelled = detail.rounding > 0;
  const trim = (free: boolean): number => (free && bevelled ? BEVEL.length : 0);
  const low = -run.halfLength + trim(run.ends.low);
  const high = run.halfLength - trim(run.ends.high);
  addWalls(builder, frame, polygon, [low, high]);
  for (const side of [1, -1] as const) {
    if (side > 0 ? run.ends.high : run.ends.low) {
      addEnd(builder, frame, polygon, [side > 0 ? high : low, side * run.halfLength]);
    } else {
      addPolygon(builder, frame, { contour: polygon, holes: [] }, side * run.halfLength);
    }
  }
}

function addWalls(
  builder: MeshBuilder,
  frame: Frame,
  polygon: readonly Point2[],
  [low, high]: readonly [number, number],
): void {
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length] ?? a;
    builder.flatQuad([
      toPart(frame, a[0], a[1], low),
      toPart(frame, b[0], b[1], low),
      toPart(frame, b[0], b[1], high),
      toPart(frame, a[0], a[1], high),
    ]);
    if (isCorner(polygon, i)) {
      builder.hardLine(toPart(frame, a[0], a[1], low), toPart(frame, a[0], a[1], high));
    }
  });
}

/** True where the outline turns by more than 30 degrees: not in the middle of a wing's tip. */
function isCorner(polygon: readonly Point2[], index: number): boolean {
  const before = polygon[(index + polygon.length - 1) % polygon.length];
  const here = polygon[index];
  const after = polygon[(index + 1) % polygon.length];
  if (!before || !here || !after) {
    return false;
  }
  const a = Math.atan2(here[1] - before[1], here[0] - before[0]);
  const b = Math.atan2(after[1] - here[1], after[0] - here[0]);
  return Math.cos(b - a) < Math.cos(Math.PI / 6);
}

/** Bevel and cap of a free end, from `heights[0]` out to `heights[1]`. */
function addEnd(
  builder: MeshBuilder,
  frame: Frame,
  polygon: readonly Point2[],
  [from, to]: readonly [number, number],
): void {
  const scale = from === to ? 1 : BEVEL.scale;
  const cap = polygon.map(([x, y]): Point2 => [x * scale, y * scale]);
  const outward = to > from;
  polygon.forEach((a, i) => {
    const j = (i + 1) % polygon.length;
    const b = polygon[j] ?? a;
    const ca = cap[i] ?? a;
    const cb = cap[j] ?? b;
    if (from !== to) {
      const p = toPart(frame, a[0], a[1], from);
      const q = toPart(frame, b[0], b[1], from);
      const r = toPart(frame, cb[0], cb[1], to);
      const s = toPart(frame, ca[0], ca[1], to);
      builder.flatQuad(outward ? [p, q, r, s] : [q, p, s, r]);
    }
    builder.hardLine(toPart(frame, ca[0], ca[1], to), toPart(frame, cb[0], cb[1], to));
  });
  addPolygon(builder, frame, { contour: cap, holes: [] }, to);
}
