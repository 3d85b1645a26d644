import { normalize, scale, subtract, type Vec3 } from '../../geometry/vec.ts';
import {
  directionToPart,
  type Frame,
  type MeshBuilder,
  type Point2,
  toPart,
} from './mesh-builder.ts';

/** A triangle by the numbers of three corners of a section, counter-clockwise. */
type Triple = readonly [number, number, number];

/**
 * A bridge along the frame's z axis between bodies whose surfaces are not flat: its cross-section is
 * constant, its ends follow the two surfaces. They lie within the bodies and are seen by nobody, but close
 * the web, as files for printers want it.
 */
export interface WebShape {
  /** Cross-section, counter-clockwise, with the outward normal of the wall after each corner. */
  readonly section: readonly Point2[];
  /** Where the web starts, and where it ends, above a point of the section. */
  readonly start: (x: number, y: number) => number;
  readonly end: (x: number, y: number) => number;
  /** How the corners of the section make up its two ends. */
  readonly startFaces: readonly Triple[];
  readonly endFaces: readonly Triple[];
  /** Shades neighbouring walls as one round surface. */
  readonly round: boolean;
  readonly lines: boolean;
}

/** Adds the walls and ends of a web, and lines along its corners. */
export function addWeb(builder: MeshBuilder, frame: Frame, shape: WebShape): void {
  const { section } = shape;
  const low = (p: Point2): Vec3 => toPart(frame, p[0], p[1], shape.start(p[0], p[1]));
  const high = (p: Point2): Vec3 => toPart(frame, p[0], p[1], shape.end(p[0], p[1]));
  addEndFaces(builder, { corners: section.map(high), faces: shape.endFaces, normal: frame.z });
  const inwards = scale(frame.z, -1);
  const turned = shape.startFaces.map(([a, b, c]): Triple => [a, c, b]);
  addEndFaces(builder, { corners: section.map(low), faces: turned, normal: inwards });
  section.forEach((a, i) => {
    const b = section[(i + 1) % section.length] ?? a;
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

function addEndFaces(
  builder: MeshBuilder,
  end: {
    readonly corners: readonly Vec3[];
    readonly faces: readonly Triple[];
    readonly normal: Vec3;
  },
): void {
  const first = end.corners.map((corner) => builder.vertex(corner, end.normal))[0] ?? 0;
  for (const [a, b, c] of end.faces) {
    builder.triangle(first + a, first + b, first + c);
  }
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

/** Faces of an end whose height changes along y alone. @param segments a multiple of 4. */
export function circleFaces(segments: number): Triple[] {
  const right = (j: number): number => (j + segments) % segments;
  const left = (j: number): number => right(segments / 2 - j);
  const quarter = segments / 4;
  return Array.from({ length: segments / 2 }, (_, i) => i - quarter).flatMap((j) =>
    quadFaces([right(j), right(j + 1), left(j + 1), left(j)]),
  );
}

/** Two triangles, or one where two corners are the same. */
function quadFaces([a, b, c, d]: readonly [number, number, number, number]): Triple[] {
  const both: Triple[] = [
    [a, b, c],
    [a, c, d],
  ];
  return both.filter(([p, q, r]) => p !== q && q !== r && r !== p);
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

/**
 * Faces of an end whose height changes along one axis alone: strips across it. The first and the last of
 * them take up the corners of the sides that they lie along.
 * @param steps as of the section.
 */
export function rectangleFaces(steps: number, along: 'x' | 'y'): Triple[] {
  const count = 4 * steps;
  const from = along === 'y' ? 0 : steps;
  const corner = (i: number): number => (from + i + count) % count;
  const right = (j: number): number => corner(j);
  const left = (j: number): number => corner(3 * steps - j);
  if (steps === 1) {
    return quadFaces([right(0), right(1), left(1), left(0)]);
  }
  const faces: Triple[] = [];
  for (let j = 1; j + 1 < steps; j++) {
    faces.push(...quadFaces([right(j), right(j + 1), left(j + 1), left(j)]));
  }
  // From the second row's right end over its left end to all corners below it, and likewise at the top.
  const low = [left(1), ...Array.from({ length: steps + 1 }, (_, i) => corner(3 * steps + i))];
  const high = [
    right(steps - 1),
    ...Array.from({ length: steps + 1 }, (_, i) => corner(steps + i)),
  ];
  for (let i = 0; i + 1 < low.length; i++) {
    faces.push([right(1), low[i] ?? 0, low[i + 1] ?? 0]);
    faces.push([left(steps - 1), high[i] ?? 0, high[i + 1] ?? 0]);
  }
  return faces;
}
