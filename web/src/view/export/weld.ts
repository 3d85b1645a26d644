import type { Vec3 } from '../../geometry/vec.ts';

/** Corners nearer than this to each other are one; the smallest edge of a mesh is a hundred times longer. */
const TOLERANCE = 1e-5;

/** A closed surface whose faces share their corners. */
export interface WeldedMesh {
  readonly points: readonly Vec3[];
  /** Three places in `points` each, all different. */
  readonly faces: readonly (readonly [number, number, number])[];
}

/**
 * Makes corners one that differ by rounding (0 and 1e-16), so that faces which meet do so exactly, and leaves
 * out faces that shrink to a line by that. A mesh for drawing has a corner for each normal there.
 */
export function weld(positions: ArrayLike<number>, indices: ArrayLike<number>): WeldedMesh {
  const points: Vec3[] = [];
  const cells = new Map<string, number[]>();
  const near = (p: Vec3): number | undefined => {
    for (const key of cellsAround(p)) {
      const found = cells.get(key)?.find((id) => agree(points[id] as Vec3, p));
      if (found !== undefined) {
        return found;
      }
    }
    return undefined;
  };
  const welded = Array.from({ length: positions.length / 3 }, (_, i) => {
    const p: Vec3 = [positions[3 * i] ?? 0, positions[3 * i + 1] ?? 0, positions[3 * i + 2] ?? 0];
    const known = near(p);
    if (known !== undefined) {
      return known;
    }
    const id = points.push(p) - 1;
    const key = p.map(cellOf).join(',');
    cells.set(key, [...(cells.get(key) ?? []), id]);
    return id;
  });
  const faces: (readonly [number, number, number])[] = [];
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => welded[indices[i + k] ?? 0] ?? 0) as [
      number,
      number,
      number,
    ];
    if (a !== b && b !== c && c !== a) {
      faces.push([a, b, c]);
    }
  }
  return { points, faces };
}

function cellOf(value: number): number {
  return Math.round(value / (4 * TOLERANCE));
}

/** The cells that a point within the tolerance may lie in: one, or more beside a border. */
function cellsAround(p: Vec3): string[] {
  const sides = p.map((value) => [
    ...new Set([cellOf(value), cellOf(value - TOLERANCE), cellOf(value + TOLERANCE)]),
  ]);
  const [xs = [], ys = [], zs = []] = sides;
  return xs.flatMap((x) => ys.flatMap((y) => zs.map((z) => `${x},${y},${z}`)));
}

function agree(a: Vec3, b: Vec3): boolean {
  return [0, 1, 2].every((k) => Math.abs((a[k] ?? 0) - (b[k] ?? 0)) <= TOLERANCE);
}
