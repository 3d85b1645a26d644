import type { Vec3 } from '../../geometry/vec.ts';
import {
  directionToPart,
  type Frame,
  type MeshBuilder,
  type Point2,
  toPart,
} from './mesh-builder.ts';

/** A surface of revolution about a frame's z axis. */
export interface RevolveOptions {
  /** Sides of the full circle. */
  readonly segments: number;
  /** Brightness at each profile point; 1 when left out. */
  readonly shades?: readonly number[];
  /** Draws circles at the profile's sharp corners and, when asked for, at its two ends. */
  readonly rims: 'none' | 'corners' | 'corners-and-ends';
  readonly silhouettes?: boolean;
  /** Where the steps are, in radians, the last one too; a full circle when left out. */
  readonly angles?: readonly number[];
}

/** cos of the angle between neighbours of a profile above which they shade as one smooth surface. */
const SMOOTH_COS = Math.cos((40 * Math.PI) / 180);
/** Shorter walls get no silhouette lines. */
const MIN_SILHOUETTE_LENGTH = 0.12;

/**
 * Adds the surface swept by a profile of (radius, height) points about the frame's z axis.
 * The outside lies to the right of the profile's direction: upwards on an outer wall, inwards on an
 * upper face, downwards on the wall of a hole.
 */
export function addRevolved(
  builder: MeshBuilder,
  frame: Frame,
  profile: readonly Point2[],
  options: RevolveOptions,
): void {
  const angles = options.angles ?? fullCircle(options.segments);
  const normals = segmentNormals(profile);
  for (let i = 0; i + 1 < profile.length; i++) {
    addBand(builder, frame, { profile, normals, index: i, angles }, options);
  }
  if (options.rims !== 'none') {
    addRims(builder, frame, { profile, normals, angles }, options.rims);
  }
}

/** A ring of points about the frame's z axis, closed: the first point stands at the end again. */
export function circlePoints(
  frame: Frame,
  radius: number,
  height: number,
  angles: readonly number[],
): Vec3[] {
  return angles.map((a) => toPart(frame, radius * Math.cos(a), radius * Math.sin(a), height));
}

/** Angles of a full circle in `segments` steps, 0 and 2 pi included. */
export function fullCircle(segments: number): number[] {
  return Array.from({ length: segments + 1 }, (_, i) => (i / segments) * 2 * Math.PI);
}

interface ProfileRun {
  readonly profile: readonly Point2[];
  readonly normals: readonly Point2[];
  readonly angles: readonly number[];
}

/** Angles from one to another, both included, in steps like those of a full circle of `segments`. */
export function arcAngles(segments: number, [from, to]: readonly [number, number]): number[] {
  const span = to - from;
  const steps = Math.max(1, Math.round((segments * span) / (2 * Math.PI)));
  return Array.from({ length: steps + 1 }, (_, i) => from + (span * i) / steps);
}

function segmentNormals(profile: readonly Point2[]): Point2[] {
  const normals: Point2[] = [];
  for (let i = 0; i + 1 < profile.length; i++) {
    const [r0, t0] = at(profile, i);
    const [r1, t1] = at(profile, i + 1);
    const size = Math.hypot(r1 - r0, t1 - t0) || 1;
    normals.push([(t1 - t0) / size, (r0 - r1) / size]);
  }
  return normals;
}

function at(points: readonly Point2[], index: number): Point2 {
  return points[index] ?? [0, 0];
}

/** Normal at an end of segment `index`: shared with the neighbour when the corner is blunt. */
function endNormal(normals: readonly Point2[], index: number, neighbour: number): Point2 {
  const own = at(normals, index);
  const other = normals[neighbour];
  if (!other || own[0] * other[0] + own[1] * other[1] < SMOOTH_COS) {
    return own;
  }
  const sum: Point2 = [own[0] + other[0], own[1] + other[1]];
  const size = Math.hypot(sum[0], sum[1]) || 1;
  return [sum[0] / size, sum[1] / size];
}

function addBand(
  builder: MeshBuilder,
  frame: Frame,
  run: ProfileRun & { readonly index: number },
  options: RevolveOptions,
): void {
  const { profile, normals, angles, index } = run;
  const low = at(profile, index);
  const high = at(profile, index + 1);
  const lowNormal = endNormal(normals, index, index - 1);
  const highNormal = endNormal(normals, index, index + 1);
  const lowShade = options.shades?.[index] ?? 1;
  const highShade = options.shades?.[index + 1] ?? 1;
  let previous = -1;
  for (const angle of angles) {
    const c = Math.cos(angle);
    const s = Math.sin(angle);
    const ring = (p: Point2, n: Point2, shade: number): number =>
      builder.vertex(
        toPart(frame, p[0] * c, p[0] * s, p[1]),
        directionToPart(frame, n[0] * c, n[0] * s, n[1]),
        shade,
      );
    const current = ring(low, lowNormal, lowShade);
    ring(high, highNormal, highShade);
    if (previous >= 0) {
      addBandQuad(builder, [previous, current], [low[0], high[0]]);
    }
    previous = current;
  }
  if (
    options.silhouettes &&
    Math.hypot(high[0] - low[0], high[1] - low[1]) > MIN_SILHOUETTE_LENGTH
  ) {
    addSilhouettes(builder, frame, run);
  }
}

/** One cell of a band; a radius of zero makes it a triangle. */
function addBandQuad(
  builder: MeshBuilder,
  [previous, current]: readonly [number, number],
  [lowRadius, highRadius]: readonly [number, number],
): void {
  if (lowRadius > 0) {
    builder.triangle(previous, current, highRadius > 0 ? current + 1 : previous + 1);
  }
  if (highRadius > 0) {
    builder.triangle(previous, current + 1, previous + 1);
  }
}

function addSilhouettes(
  builder: MeshBuilder,
  frame: Frame,
  run: ProfileRun & { readonly index: number },
): void {
  const { profile, normals, angles, index } = run;
  const [r0, t0] = at(profile, index);
  const [r1, t1] = at(profile, index + 1);
  const [nr, nt] = at(normals, index);
  const faceNormal = (angle: number): Vec3 =>
    directionToPart(frame, nr * Math.cos(angle), nr * Math.sin(angle), nt);
  angles.slice(0, -1).forEach((angle, i) => {
    const after = ((angles[i + 1] ?? angle) - angle) / 2;
    const before = i > 0 ? (angle - (angles[i - 1] ?? angle)) / 2 : after;
    const c = Math.cos(angle);
    const s = Math.sin(angle);
    builder.softLine(toPart(frame, r0 * c, r0 * s, t0), toPart(frame, r1 * c, r1 * s, t1), [
      faceNormal(angle - before),
      faceNormal(angle + after),
    ]);
  });
}

function addRims(
  builder: MeshBuilder,
  frame: Frame,
  run: ProfileRun,
  rims: 'corners' | 'corners-and-ends',
): void {
  const { profile, normals, angles } = run;
  profile.forEach(([radius, height], i) => {
    const before = normals[i - 1];
    const after = normals[i];
    const isEnd = !before || !after;
    const sharp = isEnd || before[0] * after[0] + before[1] * after[1] < SMOOTH_COS;
    if (radius > 0 && sharp && (!isEnd || rims === 'corners-and-ends')) {
      builder.hardPolyline(circlePoints(frame, radius, height, angles));
    }
  });
}
