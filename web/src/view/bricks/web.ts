import { normalize, subtract, type Vec3 } from '../../geometry/vec.ts';
import {
  directionToPart,
  type Frame,
  type MeshBuilder,
  type Point2,
  toPart,
} from './mesh-builder.ts';

/**
 * A bridge along the frame's z axis between bodies whose surfaces are not flat: its cross-section is
 * constant, its ends follow the two surfaces. Ends lie inside the bodies and need no caps.
 */
export interface WebShape {
  /** Cross-section, counter-clockwise, with the outward normal of the wall after each corner. */
  readonly section: readonly Point2[];
  /** Where the web starts, and where it ends, above a point of the section. */
  readonly start: (x: number, y: number) => number;
  readonly end: (x: number, y: number) => number;
  /** Shades neighbouring walls as one round surface. */
  readonly round: boolean;
  readonly lines: boolean;
}

/** Adds the walls of a web, and lines along its corners. */
export function addWeb(builder: MeshBuilder, frame: Frame, shape: WebShape): void {
  const { section } = shape;
  section.forEach((a, i) => {
    const b = section[(i + 1) % section.length] ?? a;
    const low = (p: Point2): Vec3 => toPart(frame, p[0], p[1], shape.start(p[0], p[1]));
    const high = (p: Point2): Vec3 => toPart(frame, p[0], p[1], shape.end(p[0], p[1]));
    const flat = wallNormal(frame, a, b);
    const at = (p: Point2): Vec3 => (shape.round ? radial(frame, p) : flat);
    const first = builder.vertex(low(a), at(a));
    builder.vertex(low(b), at(b));
    builder.vertex(high(b), at(b));
    builder.vertex(high(a), at(a));
    builder.quad(first, first + 1, first + 2, first + 3);
    if (shape.lines) {
      addUpright(builder, frame, { shape, index: i, line: [low(a), high(a)] });
    }
  });
}

function addUpright(
  builder: MeshBuilder,
  frame: Frame,
  spot: {
    readonly shape: WebShape;
    readonly index: number;
    readonly line: readonly [Vec3, Vec3];
  },
): void {
  const { section } = spot.shape;
  const a = section[spot.index] ?? [0, 0];
  const before = section[(spot.index + section.length - 1) % section.length] ?? a;
  const after = section[(spot.index + 1) % section.length] ?? a;
  const n1 = wallNormal(frame, before, a);
  const n2 = wallNormal(frame, a, after);
  if (n1[0] * n2[0] + n1[1] * n2[1] + n1[2] * n2[2] < 0.7) {
    builder.hardLine(spot.line[0], spot.line[1]);
  } else {
    builder.softLine(spot.line[0], spot.line[1], [n1, n2]);
  }
}

function wallNormal(frame: Frame, a: Point2, b: Point2): Vec3 {
  return normalize(directionToPart(frame, b[1] - a[1], a[0] - b[0], 0));
}

function radial(frame: Frame, p: Point2): Vec3 {
  return normalize(subtract(toPart(frame, p[0], p[1], 0), frame.origin));
}

/** A circle as a cross-section. */
export function circleSection(radius: number, segments: number): Point2[] {
  return Array.from({ length: segments }, (_, i): Point2 => {
    const angle = (i / segments) * 2 * Math.PI;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}

/**
 * A rectangle as a cross-section, its sides divided so that curved ends follow their bodies.
 * @param x low and high.
 * @param y low and high.
 * @param steps divisions of each side.
 */
export function rectangleSection(
  x: readonly [number, number],
  y: readonly [number, number],
  steps: number,
): Point2[] {
  const points: Point2[] = [];
  const corners: Point2[] = [
    [x[1], y[0]],
    [x[1], y[1]],
    [x[0], y[1]],
    [x[0], y[0]],
  ];
  corners.forEach((a, i) => {
    const b = corners[(i + 1) % 4] ?? a;
    for (let k = 0; k < steps; k++) {
      points.push([a[0] + ((b[0] - a[0]) * k) / steps, a[1] + ((b[1] - a[1]) * k) / steps]);
    }
  });
  return points;
}
