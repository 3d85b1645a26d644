import type { Mat3, Vec3 } from '../geometry/vec.ts';

// LDraw's space: LDU, Y down. Ours: modules, Z up.

const LDU_PER_MODULE = 20;

/** A place in LDraw's own coordinates: position in LDU, rotation row by row. */
export interface Turned {
  readonly position: Vec3;
  readonly rotation: Mat3;
}

/** What is placed inside of what is placed. */
export function compose(outer: Turned, inner: Turned): Turned {
  const m = outer.rotation;
  const n = inner.rotation;
  const p = inner.position;
  const o = outer.position;
  const row = (i: 0 | 3 | 6, j: 0 | 1 | 2): number =>
    (m[i] ?? 0) * (n[j] ?? 0) +
    (m[(i + 1) as 1 | 4 | 7] ?? 0) * (n[(j + 3) as 3 | 4 | 5] ?? 0) +
    (m[(i + 2) as 2 | 5 | 8] ?? 0) * (n[(j + 6) as 6 | 7 | 8] ?? 0);
  return {
    position: [
      o[0] + m[0] * p[0] + m[1] * p[1] + m[2] * p[2],
      o[1] + m[3] * p[0] + m[4] * p[1] + m[5] * p[2],
      o[2] + m[6] * p[0] + m[7] * p[1] + m[8] * p[2],
    ],
    rotation: [
      row(0, 0),
      row(0, 1),
      row(0, 2),
      row(3, 0),
      row(3, 1),
      row(3, 2),
      row(6, 0),
      row(6, 1),
      row(6, 2),
    ],
  };
}

export function determinant([a, b, c, d, e, f, g, h, i]: Mat3): number {
  return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
}

/** LDraw (x, y, z) in LDU is (x, z, -y) in modules. */
export function toModules(p: Vec3): Vec3 {
  const s = 1 / LDU_PER_MODULE;
  return [neat(p[0] * s), neat(p[2] * s), neat(-p[1] * s)];
}

/** The inverse of R -> M R M^T with M: (x, y, z) -> (x, -z, y). */
export function toOurs(r: Mat3): Mat3 {
  const turned: Mat3 = [r[0], r[2], -r[1], r[6], r[8], -r[7], -r[3], -r[5], r[4]];
  return turned.map(neat) as unknown as Mat3;
}

/** Six decimals, and never -0. */
export function neat(value: number): number {
  const rounded = Math.round(value * 1e6) / 1e6;
  return rounded === 0 ? 0 : rounded;
}
