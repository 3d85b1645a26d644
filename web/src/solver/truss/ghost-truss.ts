import type { Highs } from 'highs';
import { add, cross, length, normalize, scale, subtract, type Vec3 } from '../../geometry/vec.ts';
import type { BridgeContest } from '../../model/contest/bridge.ts';
import type { SketchDocument, SketchLine } from '../../model/sketch.ts';

/**
 * The lightest flat truss under a deck, by linear programming over lattice lines (ground structure method, Dorn, Gomory
 * and Greenberg 1964). For each member m a strength a_m >= 0 and for each place k of the truck a force q_mk, in newtons:
 *
 *   minimise  sum of l_m a_m   so that   |q_mk| <= a_m   and   in each free node and direction   sum of q_mk d_m = p_k
 *
 * Joints are hinges, weight of the members is left out, and the strength may be anything: no model can be lighter for its
 * strength, and none of real beams is as light. One end rests on a hinge, the other on a roller.
 */

/** A member from node to node, as places along the deck and above the table, modules. */
export interface TrussMember {
  readonly from: readonly [number, number];
  readonly to: readonly [number, number];
  /** N, the greatest force in it. */
  readonly strength: number;
}

export interface GhostTruss {
  readonly members: readonly TrussMember[];
  /** Sum of length times strength, N modules: what no other truss of such lines is under. */
  readonly volume: number;
}

/** A beam of 15 holes. */
const LONGEST = 14;
/** Nodes stand so many modules apart, the first of these that the deck is a multiple of. */
const SPACINGS = [2, 3, 4, 1];
/** The deck hangs in points so many modules apart, the first of these that it is a multiple of; between them it carries itself. */
const PANELS = [8, 6, 4, 2, 3, 1];
/** The truss may rise so far above the deck. */
const RISE = 6;
/** Above that the programme takes too long. */
const MOST_LENGTH = 32;
const TOLERANCE = 1e-6;

type Place = readonly [number, number];

interface Ground {
  readonly nodes: readonly Place[];
  /** Pairs of nodes. */
  readonly members: readonly (readonly [number, number])[];
  /** Where the deck hangs. */
  readonly deck: readonly number[];
  readonly panel: number;
}

/** Why there is no such truss; null where there is one. */
export function faultOfGhost({ deck }: BridgeContest): string | null {
  const along = length(subtract(deck.to, deck.from));
  return Number.isInteger(along) && along <= MOST_LENGTH && deck.from[2] === deck.to[2]
    ? null
    : `deck: a level stretch of whole length up to ${MOST_LENGTH} is needed`;
}

/** All nodes, and the members of legal length that pass by no third node. */
function groundOf({ deck }: BridgeContest): Ground {
  const along = length(subtract(deck.to, deck.from));
  const spacing = SPACINGS.find((one) => along % one === 0) ?? 1;
  const height = deck.from[2];
  const columns = steps(0, along, spacing);
  const levels = steps(height % spacing, height + RISE, spacing);
  const nodes = columns.flatMap((x) => levels.map((z): Place => [x, z]));
  const members = nodes.flatMap((a, i) =>
    nodes.slice(i + 1).flatMap((b, k) => (isLegal(a, b, spacing) ? [[i, i + 1 + k] as const] : [])),
  );
  const panel = PANELS.find((one) => along % one === 0) ?? 1;
  const deckNodes = nodes.flatMap(([x, z], i) => (z === height && x % panel === 0 ? [i] : []));
  return { nodes, members, deck: deckNodes, panel };
}

function steps(from: number, to: number, by: number): number[] {
  return Array.from({ length: Math.floor((to - from) / by) + 1 }, (_, i) => from + i * by);
}

function isLegal(a: Place, b: Place, spacing: number): boolean {
  const [dx, dz] = [Math.abs(b[0] - a[0]), Math.abs(b[1] - a[1])];
  const span = Math.hypot(dx, dz);
  return span <= LONGEST && Number.isInteger(span) && divisor(dx, dz) === spacing;
}

function divisor(a: number, b: number): number {
  return b === 0 ? a : divisor(b, a % b);
}

/** The weight on each node of the deck with the truck in one place; a wheel between two points of the deck rests on both. */
function loadsAt({ truck }: BridgeContest, ground: Ground, front: number): number[] {
  const { nodes, deck, panel } = ground;
  // One truss on each side.
  const half = truck.track === 0 ? 1 : 2;
  return nodes.map(([x], node) =>
    deck.includes(node)
      ? truck.axles.reduce((sum, behind, axle) => {
          const off = Math.abs(front - behind - x) / panel;
          return sum + (off < 1 ? ((1 - off) * (truck.forces[axle] ?? 0)) / half : 0);
        }, 0)
      : 0,
  );
}

/**
 * Where the truck is looked at: with an axle on a point of the deck. Between two such places loads change in proportion, and
 * so can the forces in the members: what holds in both holds in between.
 */
function frontsOf({ truck }: BridgeContest, { nodes, deck }: Ground): number[] {
  const fronts = deck.flatMap((node) =>
    truck.axles.map((behind) => (nodes[node]?.[0] ?? 0) + behind),
  );
  return [...new Set(fronts)].sort((a, b) => a - b);
}

/** \pre faultOfGhost is null. */
export function ghostTruss(contest: BridgeContest, highs: Highs): GhostTruss {
  const ground = groundOf(contest);
  const { nodes, members } = ground;
  const cases = frontsOf(contest, ground)
    .map((front) => loadsAt(contest, ground, front))
    .filter((loads) => loads.some((load) => load > 0));
  const model = highs.createModel();
  model.options.set({ output_flag: false });
  const along = length(subtract(contest.deck.to, contest.deck.from));
  const low = Math.min(...nodes.map(([, z]) => z));
  const free = (node: number, axis: 0 | 1): boolean => {
    const [x, z] = nodes[node] ?? [0, 0];
    const foot = z === low && (x === 0 || x === along);
    return !foot || (axis === 0 && x !== 0);
  };
  const strengths = members.map(([a, b]) => {
    const { span } = directionOf(nodes, a, b);
    model.addCol(span, 0, Number.POSITIVE_INFINITY, { indices: [], values: [] });
    return model.getDimensions().numCols - 1;
  });
  for (const loads of cases) {
    const row = new Map<string, number>();
    nodes.forEach((_, node) => {
      for (const axis of [0, 1] as const) {
        if (free(node, axis)) {
          const load = axis === 1 ? (loads[node] ?? 0) : 0;
          model.addRow(load, load, { indices: [], values: [] });
          row.set(`${node}/${axis}`, model.getDimensions().numRows - 1);
        }
      }
    });
    members.forEach(([a, b], m) => {
      const { dx, dz } = directionOf(nodes, a, b);
      // Tension pulls each end towards the other; compression the other way round.
      const pulls = [
        [`${a}/0`, dx],
        [`${a}/1`, dz],
        [`${b}/0`, -dx],
        [`${b}/1`, -dz],
      ] as const;
      const known = pulls.flatMap(([key, value]) => {
        const at = row.get(key);
        return at === undefined || value === 0 ? [] : [[at, value] as const];
      });
      model.addRow(0, Number.POSITIVE_INFINITY, { indices: [strengths[m] ?? 0], values: [1] });
      const limit = model.getDimensions().numRows - 1;
      for (const sign of [1, -1]) {
        model.addCol(0, 0, Number.POSITIVE_INFINITY, {
          indices: [...known.map(([at]) => at), limit],
          values: [...known.map(([, value]) => sign * value), -1],
        });
      }
    });
  }
  model.run();
  const { colValue } = model.getSolution();
  const volume = model.getObjectiveValue();
  model.dispose();
  const found = members.flatMap(([a, b], m): TrussMember[] => {
    const strength = colValue[strengths[m] ?? 0] ?? 0;
    return strength > TOLERANCE
      ? [{ from: nodes[a] ?? [0, 0], to: nodes[b] ?? [0, 0], strength }]
      : [];
  });
  return { members: found, volume };
}

function directionOf(nodes: readonly Place[], a: number, b: number) {
  const [ax, az] = nodes[a] ?? [0, 0];
  const [bx, bz] = nodes[b] ?? [0, 0];
  const span = Math.hypot(bx - ax, bz - az);
  return { span, dx: (bx - ax) / span, dz: (bz - az) / span };
}

/** A drawing of the ghost: the truss and the deck on each side, joined across where lines meet at an angle. */
export function ghostSketch(
  { deck, truck }: BridgeContest,
  { members }: GhostTruss,
  name: string,
): SketchDocument {
  const along = normalize(subtract(deck.to, deck.from));
  const aside = normalize(cross([0, 0, 1], along));
  const at = ([x, z]: Place, side: number): Vec3 => {
    const [px, py] = add(add(deck.from, scale(along, x)), scale(aside, side));
    return [round(px), round(py), z];
  };
  const height = deck.from[2];
  const road = [
    [0, height],
    [length(subtract(deck.to, deck.from)), height],
  ] as const;
  const pieces = [...members.map(({ from, to }) => ordered([from, to])), ordered(road)];
  const all = joinedBars(pieces);
  const sides = truck.track === 0 ? [0] : [-truck.track / 2, truck.track / 2];
  const trusses = sides.flatMap((side) =>
    all.map(([from, to]): SketchLine => ({ from: at(from, side), to: at(to, side) })),
  );
  const [left = 0, right = 0] = sides;
  const across = cornersOf(pieces).map(
    (place): SketchLine => ({ from: at(place, left), to: at(place, right) }),
  );
  const lines = sides.length === 1 ? trusses : [...trusses, ...across];
  return { format: 'technic-sketch', version: 1, name, lines };
}

type Bar = readonly [Place, Place];

/** Bars in line that touch or overlap, as one; a place at an angle between two of them stays a corner. */
export function joinedBars(bars: readonly Bar[]): Bar[] {
  const lines = new Map<string, Bar[]>();
  for (const bar of bars.map(ordered)) {
    lines.set(lineText(bar), [...(lines.get(lineText(bar)) ?? []), bar]);
  }
  return [...lines.values()].flatMap((inLine) => {
    const joined: Bar[] = [];
    for (const bar of inLine.sort(([a], [b]) => compare(a, b))) {
      const last = joined.at(-1);
      if (last && compare(bar[0], last[1]) <= 0) {
        joined[joined.length - 1] = [last[0], compare(last[1], bar[1]) < 0 ? bar[1] : last[1]];
      } else {
        joined.push(bar);
      }
    }
    return joined;
  });
}

function compare([ax, az]: Place, [bx, bz]: Place): number {
  return ax - bx || az - bz;
}

function ordered([a, b]: Bar): Bar {
  return compare(a, b) <= 0 ? [a, b] : [b, a];
}

/** Equal texts, the same endless line. */
function lineText([[ax, az], [bx, bz]]: Bar): string {
  const span = Math.hypot(bx - ax, bz - az);
  const [dx, dz] = [(bx - ax) / span, (bz - az) / span];
  return [dx, dz, ax * dz - az * dx].map((x) => Math.round(x * 1e6) + 0).join();
}

/** Where lines end that are not of one direction. */
function cornersOf(bars: readonly Bar[]): Place[] {
  const directions = new Map<string, { place: Place; seen: Set<string> }>();
  for (const bar of bars) {
    const direction = lineText(bar).split(',').slice(0, 2).join();
    for (const place of bar) {
      const known = directions.get(place.join()) ?? { place, seen: new Set() };
      known.seen.add(direction);
      directions.set(place.join(), known);
    }
  }
  return [...directions.values()].flatMap(({ place, seen }) => (seen.size > 1 ? [place] : []));
}

function round(x: number): number {
  return Math.round(x * 1e6) / 1e6 + 0;
}
