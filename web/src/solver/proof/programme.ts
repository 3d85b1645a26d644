import type { Placements } from './placements.ts';

/**
 * The integer programme of a proof: choose columns (covers), each at most once, so that the rows hold and
 * the chosen cost least. Rows are numbered as the certificate numbers them: all edges, then all runs, then
 * the lists of rivals, then the limits (docs/lower-bound.md).
 */
export interface Programme {
  readonly columns: readonly Column[];
  readonly rows: readonly Row[];
}

export interface Column {
  readonly cost: number;
  /** Row numbers, ascending, with this column's factor in each. */
  readonly rows: readonly number[];
  readonly factors: readonly number[];
}

/** The sum of its columns is at least `least`, or at most `most`. */
export type Row =
  | { readonly kind: 'least'; readonly least: number }
  | { readonly kind: 'most'; readonly most: number };

/** The rows that ask for a cover. Edges that nothing covers stay out: no layout covers them. */
export function makeProgramme(placements: Placements): Programme {
  const { edges, runs, covers, rivals, limits } = placements;
  const rows: Row[] = [
    ...edges.map(() => ({ kind: 'least', least: 1 }) as const),
    ...runs.map(() => ({ kind: 'least', least: 1 }) as const),
    ...rivals.map(() => ({ kind: 'most', most: 1 }) as const),
    ...limits.map(({ owned }) => ({ kind: 'most', most: owned }) as const),
  ];
  const rivalRows = covers.map((): number[] => []);
  rivals.forEach((list, i) => {
    for (const cover of list) {
      rivalRows[cover]?.push(edges.length + runs.length + i);
    }
  });
  const columns = covers.map((cover, c): Column => {
    const plain = [
      ...cover.edges,
      ...cover.runs.map((run) => edges.length + run),
      ...(rivalRows[c] ?? []),
    ];
    const limit = limits.findIndex(({ part }) => part === cover.part);
    return {
      cost: cover.parts,
      rows: limit < 0 ? plain : [...plain, rows.length - limits.length + limit],
      factors: [...plain.map(() => 1), ...(limit < 0 ? [] : [cover.parts])],
    };
  });
  return { columns, rows };
}

/** Columns and rows that hang together: what is proved of each adds up. */
export interface Piece {
  readonly columns: readonly number[];
  readonly rows: readonly number[];
}

/** The pieces of a programme that share no column. A row without columns belongs to none. */
export function piecesOf({ columns, rows }: Programme): Piece[] {
  const root = rows.map((_, row) => row);
  const rootOf = (row: number): number => {
    let at = row;
    while (root[at] !== at) {
      at = root[at] as number;
    }
    root[row] = at;
    return at;
  };
  for (const column of columns) {
    const first = rootOf(column.rows[0] as number);
    for (const row of column.rows) {
      root[rootOf(row)] = first;
    }
  }
  const pieces = new Map<number, { columns: number[]; rows: Set<number> }>();
  columns.forEach((column, c) => {
    const mine = rootOf(column.rows[0] as number);
    const piece = pieces.get(mine) ?? { columns: [], rows: new Set() };
    pieces.set(mine, piece);
    piece.columns.push(c);
    for (const row of column.rows) {
      piece.rows.add(row);
    }
  });
  return [...pieces.values()].map((piece) => ({
    columns: piece.columns,
    rows: [...piece.rows].sort((a, b) => a - b),
  }));
}

/**
 * Columns that a cheapest choice can do with: of those that cover the same the cheapest, and none that
 * another one makes needless. Where a limit holds a column back, all stay.
 */
export function usefulColumns({ columns, rows }: Programme, piece: Piece): number[] {
  const held = (c: number) => columns[c]?.rows.some((row) => rows[row]?.kind === 'most') ?? false;
  const cheapest = new Map<string, number>();
  for (const c of piece.columns) {
    const column = columns[c] as Column;
    const key = held(c) ? `held ${c}` : column.rows.join();
    const known = cheapest.get(key);
    if (known === undefined || column.cost < (columns[known] as Column).cost) {
      cheapest.set(key, c);
    }
  }
  const left = [...cheapest.values()];
  const byRow = new Map<number, number[]>();
  for (const c of left) {
    for (const row of (columns[c] as Column).rows) {
      const list = byRow.get(row) ?? [];
      byRow.set(row, list);
      list.push(c);
    }
  }
  const sets = new Map(left.map((c) => [c, new Set((columns[c] as Column).rows)]));
  return left.filter((c) => {
    const { rows: own, cost } = columns[c] as Column;
    const listOf = (row: number) => byRow.get(row) ?? [];
    const rarest = own.reduce((a, b) => (listOf(b).length < listOf(a).length ? b : a));
    return (
      held(c) ||
      !listOf(rarest).some((other) => {
        const column = columns[other] as Column;
        const wider = column.rows.length > own.length && column.cost <= cost && !held(other);
        return wider && own.every((row) => sets.get(other)?.has(row));
      })
    );
  });
}
