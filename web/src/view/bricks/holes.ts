import { type Detail, DIMENSIONS } from './detail.ts';
import {
  directionToPart,
  type Frame,
  type MeshBuilder,
  type Point2,
  toPart,
} from './mesh-builder.ts';
import { addRevolved } from './revolve.ts';

/** Brightness inside holes: at the mouth, on the step, and deep within. */
const SHADE = { mouth: 0.92, step: 0.74, wall: 0.6, deep: 0.34 } as const;

/** The polygon that a round hole leaves open in a face, about (x, y) of the plate's frame. */
export function pinHoleOpening(x: number, y: number, detail: Detail): Point2[] {
  const radius = detail.counterbores ? DIMENSIONS.counterboreRadius : DIMENSIONS.holeRadius;
  return Array.from({ length: detail.segments }, (_, i): Point2 => {
    const angle = (i / detail.segments) * 2 * Math.PI;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

/**
 * Adds the wall of a round hole along the frame's z axis from -halfHeight to +halfHeight, with a
 * counterbore at both mouths. The faces round the mouths are the plate's.
 */
export function addPinHole(
  builder: MeshBuilder,
  frame: Frame,
  halfHeight: number,
  detail: Detail,
): void {
  const r = DIMENSIONS.holeRadius;
  const wide = DIMENSIONS.counterboreRadius;
  const step = halfHeight - DIMENSIONS.counterboreDepth;
  const wall: Point2[] = [
    [r, step],
    [r, 0],
    [r, -step],
  ];
  const profile: Point2[] = detail.counterbores
    ? [[wide, halfHeight], [wide, step], ...wall, [wide, -step], [wide, -halfHeight]]
    : [
        [r, halfHeight],
        [r, 0],
        [r, -halfHeight],
      ];
  const shades = detail.counterbores
    ? [SHADE.mouth, SHADE.step, SHADE.wall, SHADE.deep, SHADE.wall, SHADE.step, SHADE.mouth]
    : [SHADE.wall, SHADE.deep, SHADE.wall];
  addRevolved(builder, frame, profile, {
    segments: detail.segments,
    shades,
    rims: 'corners-and-ends',
  });
}

/**
 * The outline of an axle's cross, counter-clockwise, 16 corners; the first wing lies along +x.
 * @param radius to the tips of the wings.
 * @param wing half the width of a wing.
 */
export function crossPolygon(radius: number, wing: number): Point2[] {
  const tip = Math.sqrt(radius * radius - wing * wing);
  const quarter: Point2[] = [
    [tip, -wing],
    [radius, 0],
    [tip, wing],
    [wing, wing],
  ];
  return [0, 1, 2, 3].flatMap((turn) => quarter.map((point) => turned(point, turn)));
}

/** A point turned by whole quarters, exactly. */
function turned([x, y]: Point2, quarters: number): Point2 {
  if (quarters === 0) {
    return [x, y];
  }
  return quarters === 1 ? [-y, x] : quarters === 2 ? [-x, -y] : [y, -x];
}

/** The polygon that a cross hole leaves open in a face; `angle` turns its first wing from x. */
export function axleHoleOpening(x: number, y: number, angle: number): Point2[] {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return crossPolygon(DIMENSIONS.axleHoleRadius, DIMENSIONS.axleHoleWing).map(
    ([px, py]): Point2 => [x + px * c - py * s, y + px * s + py * c],
  );
}

/** Adds the wall of a cross hole along z; the frame's x axis is the direction of a wing. */
export function addAxleHole(builder: MeshBuilder, frame: Frame, halfHeight: number): void {
  const polygon = crossPolygon(DIMENSIONS.axleHoleRadius, DIMENSIONS.axleHoleWing);
  const heights = [halfHeight, 0, -halfHeight];
  const shades = [0.8, 0.3, 0.8];
  polygon.forEach((a, i) => {
    const b = polygon[(i + 1) % polygon.length] ?? a;
    const size = Math.hypot(b[0] - a[0], b[1] - a[1]);
    // The walls look inwards: to the left of a counter-clockwise outline.
    const normal = directionToPart(frame, (a[1] - b[1]) / size, (b[0] - a[0]) / size, 0);
    for (let k = 0; k < 2; k++) {
      const top = heights[k] ?? 0;
      const low = heights[k + 1] ?? 0;
      const first = builder.vertex(toPart(frame, a[0], a[1], top), normal, shades[k]);
      builder.vertex(toPart(frame, b[0], b[1], top), normal, shades[k]);
      builder.vertex(toPart(frame, b[0], b[1], low), normal, shades[k + 1]);
      builder.vertex(toPart(frame, a[0], a[1], low), normal, shades[k + 1]);
      builder.quad(first, first + 1, first + 2, first + 3);
    }
    for (const side of [1, -1]) {
      builder.hardLine(
        toPart(frame, a[0], a[1], side * halfHeight),
        toPart(frame, b[0], b[1], side * halfHeight),
      );
    }
  });
}
