import type { Highs, Model } from 'highs';
import { type Column, type Piece, type Programme, type Row, usefulColumns } from './programme.ts';

/** Of the columns that are in all of `rows` at least or at most so many are chosen. */
export interface Branch {
  readonly rows: readonly number[];
  readonly sense: Row['kind'];
  readonly count: number;
}

/** An optimum of the programme without its whole numbers. */
export interface LinearOptimum {
  readonly value: number;
  /** By place in the piece's rows; at least 0. */
  readonly prices: readonly number[];
  /** By branch, the outermost first; at least 0. */
  readonly branchPrices: readonly number[];
  /** How much of each column is chosen; what is missing is 0. */
  readonly chosen: ReadonlyMap<number, number>;
}

/** What a row costs that is not kept: more than any piece; it makes every programme solvable. */
const BREACH = 1000;
const TOLERANCE = 1e-7;

/** Whether a column is in all of these rows, ascending or not. */
export function isInAll(column: Column, rows: readonly number[]): boolean {
  return rows.every((row) => column.rows.includes(row));
}

/** A row's dual value without the solver's sign, and without its noise. */
function priceOf(kind: Row['kind'], dual: number | undefined): number {
  return Math.max(0, (kind === 'most' ? -1 : 1) * (dual ?? 0));
}

/**
 * One piece as a linear programme in HiGHS, with branches on top. It begins with the useful columns; any
 * other is added once the prices make it worth while, so that the prices hold for all.
 */
export class LinearPiece {
  readonly #programme: Programme;
  readonly #piece: Piece;
  readonly #model: Model;
  readonly #place = new Map<number, number>();
  readonly #branches: Branch[] = [];
  /** The columns of the model; null where one stands for breaches of a row. */
  readonly #columns: (number | null)[] = [];
  readonly #idle: Set<number>;

  constructor(highs: Highs, programme: Programme, piece: Piece) {
    this.#programme = programme;
    this.#piece = piece;
    this.#model = highs.createModel();
    this.#model.options.set({ output_flag: false, presolve: 'off' });
    this.#idle = new Set(piece.columns);
    piece.rows.forEach((row, place) => {
      this.#place.set(row, place);
      const kept = programme.rows[row] as Row;
      this.#addRow(kept.kind, kept.kind === 'most' ? kept.most : kept.least, []);
    });
    for (const c of usefulColumns(programme, piece)) {
      this.#addColumn(c);
    }
  }

  dispose(): void {
    this.#model.dispose();
  }

  push(branch: Branch): void {
    const members: number[] = [];
    this.#columns.forEach((c, i) => {
      if (c !== null && isInAll(this.#programme.columns[c] as Column, branch.rows)) {
        members.push(i);
      }
    });
    this.#branches.push(branch);
    this.#addRow(branch.sense, branch.count, members);
  }

  pop(): void {
    this.#branches.pop();
    const last = this.#piece.rows.length + this.#branches.length;
    this.#model.deleteRows({ kind: 'range', from: last, to: last });
  }

  solve(): LinearOptimum {
    for (;;) {
      this.#model.run();
      const { colValue, rowDual } = this.#model.getSolution();
      const { rows } = this.#piece;
      const prices = rows.map((row, i) =>
        priceOf((this.#programme.rows[row] as Row).kind, rowDual[i]),
      );
      const branchPrices = this.#branches.map(({ sense }, i) =>
        priceOf(sense, rowDual[rows.length + i]),
      );
      const wanted = [...this.#idle].filter(
        (c) => this.#left(c, prices, branchPrices) < -TOLERANCE,
      );
      if (wanted.length === 0) {
        const chosen = new Map<number, number>();
        this.#columns.forEach((c, i) => {
          if (c !== null && (colValue[i] ?? 0) > TOLERANCE) {
            chosen.set(c, colValue[i] as number);
          }
        });
        return { value: this.#model.getObjectiveValue(), prices, branchPrices, chosen };
      }
      for (const c of wanted) {
        this.#addColumn(c);
      }
    }
  }

  /** What a column costs beyond the prices of its rows. */
  #left(c: number, prices: readonly number[], branchPrices: readonly number[]): number {
    const { cost, rows, factors } = this.#programme.columns[c] as Column;
    let left = cost;
    rows.forEach((row, k) => {
      const sign = this.#programme.rows[row]?.kind === 'most' ? -1 : 1;
      left -= sign * (factors[k] as number) * (prices[this.#place.get(row) as number] ?? 0);
    });
    this.#branches.forEach((branch, i) => {
      if (isInAll(this.#programme.columns[c] as Column, branch.rows)) {
        left += (branch.sense === 'most' ? 1 : -1) * (branchPrices[i] ?? 0);
      }
    });
    return left;
  }

  #addColumn(c: number): void {
    const { cost, rows, factors } = this.#programme.columns[c] as Column;
    const indices = rows.map((row) => this.#place.get(row) as number);
    const values = [...factors];
    this.#branches.forEach((branch, i) => {
      if (isInAll(this.#programme.columns[c] as Column, branch.rows)) {
        indices.push(this.#piece.rows.length + i);
        values.push(1);
      }
    });
    this.#model.addCol(cost, 0, 1, { indices, values });
    this.#columns.push(c);
    this.#idle.delete(c);
  }

  /** A row of some columns, with one more that stands for its breaches. */
  #addRow(sense: Row['kind'], count: number, indices: readonly number[]): void {
    const most = sense === 'most';
    const values = indices.map(() => 1);
    this.#model.addRow(most ? -Infinity : count, most ? count : Infinity, { indices, values });
    const row = this.#model.getDimensions().numRows - 1;
    this.#model.addCol(BREACH, 0, Infinity, { indices: [row], values: [most ? -1 : 1] });
    this.#columns.push(null);
  }
}
