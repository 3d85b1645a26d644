// A toy of the search: beams on a grid choose layers. Rows are two beams that overlap in one hole,
// columns are one beam. Where beams meet they must lie in neighbouring layers, and never in the same.

export const TOY = { rows: 8, columns: 8, layers: 4 } as const;

/** Layers of the left halves, the right halves, and the columns. */
export interface ToyState {
  readonly layers: readonly number[];
}

/** A seeded generator (xorshift, 32 bits): the same lesson for everybody. */
export function makeRandom(seed: number): () => number {
  let state = seed >>> 0 || 1;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    state >>>= 0;
    return state / 4294967296;
  };
}

const { rows, columns, layers: layerCount } = TOY;
export const TOY_BEAMS = 2 * rows + columns;

/** The beams over a crossing: one half or both halves of the row, and the column. */
export function stackAt(row: number, column: number): number[] {
  // The halves overlap in another column in each row, as bricks in a wall do.
  const seam = 3 + (row % 2);
  const halves = [...(column <= seam ? [row] : []), ...(column >= seam ? [rows + row] : [])];
  return [...halves, 2 * rows + column];
}

/** Trouble of one crossing: three for each beam too many in a layer, one for each empty layer. */
export function troubleAt(layers: readonly number[], row: number, column: number): number {
  const stack = stackAt(row, column).map((beam) => layers[beam] ?? 0);
  const distinct = new Set(stack).size;
  const range = Math.max(...stack) - Math.min(...stack) + 1;
  return 3 * (stack.length - distinct) + (range - distinct);
}

export function troubleOf(layers: readonly number[]): number {
  let sum = 0;
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      sum += troubleAt(layers, row, column);
    }
  }
  return sum;
}

export function randomState(random: () => number): number[] {
  return Array.from({ length: TOY_BEAMS }, () => Math.floor(random() * layerCount));
}

/** The crossings that each beam lies on, as row * columns + column. */
const CROSSINGS: readonly (readonly number[])[] = Array.from({ length: TOY_BEAMS }, (_, beam) =>
  Array.from({ length: rows * columns }, (_row, at) => at).filter((at) =>
    stackAt(Math.floor(at / columns), at % columns).includes(beam),
  ),
);

function troubleAround(layers: readonly number[], beam: number): number {
  return (CROSSINGS[beam] ?? []).reduce(
    (sum, at) => sum + troubleAt(layers, Math.floor(at / columns), at % columns),
    0,
  );
}

/**
 * One try: a beam goes to another layer, and stays there or not. Without any heat only what is better
 * stays. @returns whether it stayed.
 */
export function tryMove(layers: number[], temperature: number, random: () => number): boolean {
  const beam = Math.floor(random() * TOY_BEAMS);
  const old = layers[beam] ?? 0;
  const before = troubleAround(layers, beam);
  layers[beam] = (old + 1 + Math.floor(random() * (layerCount - 1))) % layerCount;
  const worse = troubleAround(layers, beam) - before;
  if (worse < 0 || (temperature > 0 && random() < Math.exp(-worse / temperature))) {
    return true;
  }
  layers[beam] = old;
  return false;
}
