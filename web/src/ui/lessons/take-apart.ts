// Assemblies seen from the side: parts are sets of cells, moves are straight.

export interface Cell {
  readonly x: number;
  readonly y: number;
}

export type PartCells = readonly Cell[];
export type Direction = 'left' | 'right' | 'up';

export const DIRECTIONS: Readonly<Record<Direction, Cell>> = {
  left: { x: -1, y: 0 },
  right: { x: 1, y: 0 },
  up: { x: 0, y: 1 },
};

const cells = (...pairs: readonly (readonly [number, number])[]): PartCells =>
  pairs.map(([x, y]) => ({ x, y }));

/** The first comes apart one by one; in the second two parts hold each other and leave together. */
export const ASSEMBLIES: readonly (readonly PartCells[])[] = [
  [
    cells([0, 0], [1, 0], [2, 0], [3, 0], [0, 1], [3, 1], [0, 2], [3, 2]),
    cells([1, 1], [2, 1]),
    cells([1, 2], [2, 2]),
    cells([0, 3], [1, 3], [2, 3], [3, 3]),
  ],
  [
    cells([0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [0, 1], [0, 2], [0, 3], [4, 1], [4, 2], [4, 3]),
    cells([1, 1], [1, 2], [1, 3], [2, 1], [2, 3]),
    cells([2, 2], [3, 1], [3, 2], [3, 3]),
  ],
];

/**
 * The first part in the way when some parts move together out of sight, or -1 when nothing is.
 * @param present indices of the parts that are still there.
 */
export function blockerOf(
  parts: readonly PartCells[],
  present: ReadonlySet<number>,
  moving: ReadonlySet<number>,
  direction: Direction,
): number {
  const { x: dx, y: dy } = DIRECTIONS[direction];
  const ahead = (from: Cell, other: Cell): boolean => {
    const along = (other.x - from.x) * dx + (other.y - from.y) * dy;
    const across = (other.x - from.x) * dy - (other.y - from.y) * dx;
    return along > 0 && across === 0;
  };
  for (const index of present) {
    const inWay =
      !moving.has(index) &&
      [...moving].some((mover) =>
        parts[mover]?.some((from) => parts[index]?.some((other) => ahead(from, other))),
      );
    if (inWay) {
      return index;
    }
  }
  return -1;
}
