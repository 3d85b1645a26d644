import { distance, dot, length, lerp, type Segment, subtract, type Vec3 } from './vec.ts';

/** A place where lines meet. */
export interface Meeting {
  readonly at: Vec3;
  /** Indices of the lines, ascending. */
  readonly lines: readonly number[];
  /** True at a node of all of them; false where they cross between nodes, where no pin can join them. */
  readonly atNode: boolean;
}

/** Points closer than this are one, as in the core (kSamePoint). */
const SAME_POINT = 1e-3;

/**
 * Where lines share nodes or cross between them: first the shared nodes in the order in which the
 * lines reach them, then the crossings. What collinear lines share is left out but for their ends.
 */
export function meetings(lines: readonly Segment[]): Meeting[] {
  const shared = sharedNodes(lines);
  const joined = new Set<string>();
  for (const { lines: through } of shared) {
    for (const a of through) {
      for (const b of through) {
        joined.add(`${a},${b}`);
      }
    }
  }
  const crossings = pairsNearby(lines)
    .filter(([a, b]) => !joined.has(`${a},${b}`))
    .flatMap(([a, b]): Meeting[] => {
      const first = lines[a];
      const second = lines[b];
      const at = first && second ? crossingOf(first, second) : null;
      return at ? [{ at, lines: [a, b], atNode: false }] : [];
    });
  return [...shared, ...crossings];
}

function nodeCount(line: Segment): number {
  return Math.max(1, Math.round(distance(line.from, line.to))) + 1;
}

interface Place {
  readonly at: Vec3;
  readonly lines: number[];
  ends: number;
}

/** Finds a place again within SAME_POINT: cells are wider, and the neighbours at a border are asked. */
class Places {
  readonly list: Place[] = [];
  readonly #cells = new Map<number, Place[]>();

  at(point: Vec3): Place {
    const near = this.#keysAround(point).flatMap((key) => this.#cells.get(key) ?? []);
    const known = near.find((place) => distance(place.at, point) <= SAME_POINT);
    if (known) {
      return known;
    }
    const place: Place = { at: point, lines: [], ends: 0 };
    const key = keyOf(point.map(cellOf));
    const cell = this.#cells.get(key);
    if (cell) {
      cell.push(place);
    } else {
      this.#cells.set(key, [place]);
    }
    this.list.push(place);
    return place;
  }

  #keysAround(point: Vec3): number[] {
    const [xs = [], ys = [], zs = []] = point.map((value) => {
      const low = cellOf(value - SAME_POINT);
      const high = cellOf(value + SAME_POINT);
      return low === high ? [low] : [low, high];
    });
    return xs.flatMap((x) => ys.flatMap((y) => zs.map((z) => keyOf([x, y, z]))));
  }
}

/** Shifted, because most points are whole numbers and would all lie on borders. */
function cellOf(value: number): number {
  return Math.floor(value * 8 + 0.4);
}

/** One whole number for a cell: coordinates are within 2000 modules (DESIGN 3), so nothing overlaps. */
function keyOf([x = 0, y = 0, z = 0]: readonly number[]): number {
  const side = 2 ** 16;
  const half = side / 2;
  return ((x + half) * side + (y + half)) * side + (z + half);
}

function sharedNodes(lines: readonly Segment[]): Meeting[] {
  const places = new Places();
  lines.forEach((line, index) => {
    const count = nodeCount(line);
    for (let i = 0; i < count; i++) {
      const place = places.at(lerp(line.from, line.to, i / (count - 1)));
      place.ends += i === 0 || i === count - 1 ? 1 : 0;
      if (place.lines.at(-1) !== index) {
        place.lines.push(index);
      }
    }
  });
  return places.list
    .filter((place) => place.lines.length > 1 && (place.ends > 0 || !areParallel(lines, place)))
    .map((place) => ({ at: place.at, lines: place.lines, atNode: true }));
}

/** True when all lines through the place run in one direction: they overlap there. */
function areParallel(lines: readonly Segment[], place: Place): boolean {
  const [first, ...others] = place.lines.flatMap((index) => lines[index] ?? []);
  return others.every(
    (other) => first !== undefined && sineSquared(first, other) < SAME_POINT ** 2,
  );
}

function sineSquared(a: Segment, b: Segment): number {
  const u = subtract(a.to, a.from);
  const v = subtract(b.to, b.from);
  const cosine = dot(u, v) / (length(u) * length(v));
  return Math.max(0, 1 - cosine * cosine);
}

/** Pairs of lines that pass through a common cell of 4 modules, each once, ascending. */
function pairsNearby(lines: readonly Segment[]): [number, number][] {
  const cells = new Map<number, Set<number>>();
  lines.forEach((line, index) => {
    for (const key of cellsAlong(line)) {
      const cell = cells.get(key);
      if (cell) {
        cell.add(index);
      } else {
        cells.set(key, new Set([index]));
      }
    }
  });
  const pairs = new Map<string, [number, number]>();
  for (const cell of cells.values()) {
    const members = [...cell];
    members.forEach((a, i) => {
      for (const b of members.slice(i + 1)) {
        pairs.set(`${a},${b}`, [a, b]);
      }
    });
  }
  return [...pairs.values()].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
}

const CELL = 4;

/** The cells that a line touches: those around the module-wide box about each node. */
function cellsAlong(line: Segment): Set<number> {
  const keys = new Set<number>();
  const count = nodeCount(line);
  for (let i = 0; i < count; i++) {
    const at = lerp(line.from, line.to, i / (count - 1));
    for (let corner = 0; corner < 8; corner++) {
      const cell = at.map((value, k) =>
        Math.floor((value + ((corner >> k) & 1 ? 0.6 : -0.6)) / CELL),
      );
      keys.add(keyOf(cell));
    }
  }
  return keys;
}

/** Where two lines that are not parallel cross inside both, or null. */
function crossingOf(a: Segment, b: Segment): Vec3 | null {
  const u = subtract(a.to, a.from);
  const v = subtract(b.to, b.from);
  const offset = subtract(a.from, b.from);
  const uu = dot(u, u);
  const vv = dot(v, v);
  const uv = dot(u, v);
  const determinant = uu * vv - uv * uv;
  if (determinant < 1e-9 * uu * vv) {
    return null;
  }
  const s = (uv * dot(v, offset) - vv * dot(u, offset)) / determinant;
  const t = (uu * dot(v, offset) - uv * dot(u, offset)) / determinant;
  const slackA = SAME_POINT / Math.sqrt(uu);
  const slackB = SAME_POINT / Math.sqrt(vv);
  const inside = s >= -slackA && s <= 1 + slackA && t >= -slackB && t <= 1 + slackB;
  const onA = lerp(a.from, a.to, s);
  return inside && distance(onA, lerp(b.from, b.to, t)) <= SAME_POINT ? onA : null;
}
