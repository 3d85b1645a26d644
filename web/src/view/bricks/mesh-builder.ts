import { add, cross, dot, normalize, scale, subtract, type Vec3 } from '../../geometry/vec.ts';

/** A right-handed local frame: axes are unit vectors in part coordinates. */
export interface Frame {
  readonly origin: Vec3;
  readonly x: Vec3;
  readonly y: Vec3;
  readonly z: Vec3;
}

/** A point of a plane figure. */
export type Point2 = readonly [number, number];

/**
 * Plain arrays of one part's mesh and of its drawn lines, ready for a graphics buffer.
 * Lines carry the normals of the two faces that meet there: a line with two zero normals is always
 * drawn, any other only where it is a silhouette (one face towards the eye, one away).
 */
export interface BrickMesh {
  /** 3 per vertex, modules. */
  readonly positions: Float32Array;
  /** 3 per vertex, unit length. */
  readonly normals: Float32Array;
  /** 1 per vertex: 1 in the open, less in holes (a fixed stand-in for ambient occlusion). */
  readonly shades: Float32Array;
  /** 3 per triangle, counter-clockwise from outside. */
  readonly indices: Uint32Array;
  /** 3 per line end, two ends per line. */
  readonly linePositions: Float32Array;
  readonly lineNormals1: Float32Array;
  readonly lineNormals2: Float32Array;
}

const ZERO: Vec3 = [0, 0, 0];

/** Local coordinates to part coordinates. */
export function toPart(frame: Frame, x: number, y: number, z: number): Vec3 {
  const o = frame.origin;
  return [
    o[0] + frame.x[0] * x + frame.y[0] * y + frame.z[0] * z,
    o[1] + frame.x[1] * x + frame.y[1] * y + frame.z[1] * z,
    o[2] + frame.x[2] * x + frame.y[2] * y + frame.z[2] * z,
  ];
}

/** A local direction in part coordinates. */
export function directionToPart(frame: Frame, x: number, y: number, z: number): Vec3 {
  return subtract(toPart(frame, x, y, z), frame.origin);
}

/**
 * A frame with the given z axis.
 * @param xHint a direction that x comes as near to as it can; any perpendicular when left out.
 */
export function frameAlong(origin: Vec3, z: Vec3, xHint?: Vec3): Frame {
  const axis = normalize(z);
  const fallback: Vec3 = Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  const hint = xHint && Math.abs(dot(normalize(xHint), axis)) < 0.99 ? xHint : fallback;
  const x = normalize(subtract(hint, scale(axis, dot(hint, axis))));
  return { origin, x, y: cross(axis, x), z: axis };
}

/** The same frame with another origin, `t` along its z axis. */
export function shifted(frame: Frame, t: number): Frame {
  return { ...frame, origin: add(frame.origin, scale(frame.z, t)) };
}

/** The frame turned half round its x axis: looks along -z. */
export function reversed(frame: Frame): Frame {
  return { origin: frame.origin, x: frame.x, y: scale(frame.y, -1), z: scale(frame.z, -1) };
}

/** Collects triangles and lines. Coordinates are part coordinates; see BrickMesh. */
export class MeshBuilder {
  readonly #positions: number[] = [];
  readonly #normals: number[] = [];
  readonly #shades: number[] = [];
  readonly #indices: number[] = [];
  readonly #linePositions: number[] = [];
  readonly #lineNormals1: number[] = [];
  readonly #lineNormals2: number[] = [];

  /** Adds a vertex. @returns its index. */
  vertex(position: Vec3, normal: Vec3, shade = 1): number {
    this.#positions.push(position[0], position[1], position[2]);
    this.#normals.push(normal[0], normal[1], normal[2]);
    this.#shades.push(shade);
    return this.#shades.length - 1;
  }

  triangle(a: number, b: number, c: number): void {
    this.#indices.push(a, b, c);
  }

  /** Two triangles a-b-c and a-c-d. */
  quad(a: number, b: number, c: number, d: number): void {
    this.#indices.push(a, b, c, a, c, d);
  }

  /** A flat quad with its own vertices, counter-clockwise from outside. */
  flatQuad(corners: readonly [Vec3, Vec3, Vec3, Vec3], shade = 1): void {
    const [a, b, c, d] = corners;
    const normal = normalize(cross(subtract(b, a), subtract(c, a)));
    const first = this.vertex(a, normal, shade);
    this.vertex(b, normal, shade);
    this.vertex(c, normal, shade);
    this.vertex(d, normal, shade);
    this.quad(first, first + 1, first + 2, first + 3);
  }

  /** A flat polygon, counter-clockwise from outside, all of which is seen from its first corner. */
  flatFan(corners: readonly Vec3[], shade = 1): void {
    const [a = ZERO, b = ZERO, c = ZERO] = corners;
    const normal = normalize(cross(subtract(b, a), subtract(c, a)));
    const first = corners.map((corner) => this.vertex(corner, normal, shade))[0] ?? 0;
    for (let i = 1; i + 1 < corners.length; i++) {
      this.triangle(first, first + i, first + i + 1);
    }
  }

  /** A line that is always drawn. */
  hardLine(a: Vec3, b: Vec3): void {
    this.softLine(a, b, [ZERO, ZERO]);
  }

  /** A line on a smooth surface that is drawn where the surface turns away from the eye. */
  softLine(a: Vec3, b: Vec3, normals: readonly [Vec3, Vec3]): void {
    this.#linePositions.push(...a, ...b);
    for (let end = 0; end < 2; end++) {
      this.#lineNormals1.push(...normals[0]);
      this.#lineNormals2.push(...normals[1]);
    }
  }

  /** Hard lines along a polyline; `closed` is told by repeating the first point. */
  hardPolyline(points: readonly Vec3[]): void {
    for (let i = 0; i + 1 < points.length; i++) {
      this.hardLine(points[i] ?? ZERO, points[i + 1] ?? ZERO);
    }
  }

  build(): BrickMesh {
    return {
      positions: new Float32Array(this.#positions),
      normals: new Float32Array(this.#normals),
      shades: new Float32Array(this.#shades),
      indices: new Uint32Array(this.#indices),
      linePositions: new Float32Array(this.#linePositions),
      lineNormals1: new Float32Array(this.#lineNormals1),
      lineNormals2: new Float32Array(this.#lineNormals2),
    };
  }
}
