// The paper's grid puzzle as a game: n by n cells of four units; beams of up to nine holes lie on the
// lines in layers. The same count of gaps and collisions as the program's (DESIGN 7).

/** Holes of the beams that the game offers. */
export const BEAM_HOLES: readonly number[] = [2, 3, 5, 7, 9];
export const CELL = 4;
export const LAYERS = 3;

export type PuzzleSize = 2 | 3 | 4;

/** The fewest beams of up to nine holes, proven: each line needs as many as its edges ask for. */
export const FEWEST: Readonly<Record<PuzzleSize, number>> = { 2: 6, 3: 16, 4: 20 };

/** A node of the grid, 0 to 4 n each way; one of the two lies on a line. */
export interface GridNode {
  readonly x: number;
  readonly y: number;
}

/** A beam from one node to another on one line, in a layer from 0. */
export interface GridBeam {
  readonly from: GridNode;
  readonly to: GridNode;
  readonly layer: number;
}

export interface PuzzleScore {
  readonly beams: number;
  readonly uncovered: number;
  readonly collisions: number;
  readonly gaps: number;
  /** Groups of beams that no pin joins. */
  readonly pieces: number;
  readonly complete: boolean;
}

export function isBeam(holes: number): boolean {
  return BEAM_HOLES.includes(holes);
}

/** Nodes of a beam; empty when its ends are on no common line of the grid. */
export function nodesOf(from: GridNode, to: GridNode): GridNode[] {
  const along = from.y === to.y && from.y % CELL === 0;
  const across = from.x === to.x && from.x % CELL === 0;
  if (!along && !across) {
    return [];
  }
  const steps = Math.abs(to.x - from.x) + Math.abs(to.y - from.y);
  const dx = Math.sign(to.x - from.x);
  const dy = Math.sign(to.y - from.y);
  return Array.from({ length: steps + 1 }, (_, i) => ({
    x: from.x + i * dx,
    y: from.y + i * dy,
  }));
}

/** How many holes a beam between two nodes has; 0 when they are on no common line. */
export function holesBetween(from: GridNode, to: GridNode): number {
  return nodesOf(from, to).length;
}

function keyOf({ x, y }: GridNode): string {
  return `${x},${y}`;
}

/** Judges a layout. */
export function scoreOf(size: PuzzleSize, beams: readonly GridBeam[]): PuzzleScore {
  const stacks = new Map<string, number[]>();
  const covered = new Set<string>();
  beams.forEach((beam, index) => {
    const nodes = nodesOf(beam.from, beam.to);
    nodes.forEach((node, i) => {
      const key = keyOf(node);
      stacks.set(key, [...(stacks.get(key) ?? []), index]);
      const next = nodes[i + 1];
      if (next) {
        covered.add([key, keyOf(next)].sort().join(' '));
      }
    });
  });
  let collisions = 0;
  let gaps = 0;
  for (const stack of stacks.values()) {
    const layers = stack.map((index) => beams[index]?.layer ?? 0);
    const distinct = new Set(layers).size;
    collisions += layers.length - distinct;
    gaps += Math.max(...layers) - Math.min(...layers) + 1 - distinct;
  }
  const edges = 2 * (size + 1) * CELL * size;
  const uncovered = edges - covered.size;
  const pieces = countPieces(beams.length, [...stacks.values()]);
  return {
    beams: beams.length,
    uncovered,
    collisions,
    gaps,
    pieces,
    complete: uncovered === 0 && collisions === 0 && gaps === 0 && pieces === 1,
  };
}

/** Beams that share a node are joined there by a pin. */
function countPieces(count: number, stacks: readonly (readonly number[])[]): number {
  const group = Array.from({ length: count }, (_, i) => i);
  const find = (i: number): number => {
    const above = group[i] ?? i;
    return above === i ? i : find(above);
  };
  for (const stack of stacks) {
    for (const index of stack) {
      group[find(index)] = find(stack[0] ?? index);
    }
  }
  return group.filter((above, i) => above === i).length;
}

/** The grid as a sketch in modules, for the solver. */
export function puzzleSketch(size: PuzzleSize) {
  const end = CELL * size;
  const lines = Array.from({ length: size + 1 }, (_, i) => i * CELL).flatMap(
    (at) =>
      [
        { from: [0, at, 0], to: [end, at, 0] },
        { from: [at, 0, 0], to: [at, end, 0] },
      ] as const,
  );
  return { format: 'technic-sketch', version: 1, name: `${size} x ${size}`, lines } as const;
}
