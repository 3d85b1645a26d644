import type { Highs } from 'highs';
import type { Certificate, ProofTree } from './certificate.ts';
import { type Branch, isInAll, type LinearOptimum, LinearPiece } from './linear.ts';
import type { Placements } from './placements.ts';
import {
  type Column,
  makeProgramme,
  type Piece,
  type Programme,
  piecesOf,
  usefulColumns,
} from './programme.ts';

export interface ProofOptions {
  /** Seconds that HiGHS may take for the whole numbers of one piece. */
  readonly seconds: number;
  /** Leaves that the proof of one piece may have before a lower bound is proved instead. */
  readonly leaves: number;
  readonly onProgress?: (progress: ProofProgress) => void;
}

export interface ProofProgress {
  /** Pieces that are done, of how many. */
  readonly done: number;
  readonly pieces: number;
  readonly leaves: number;
}

export const PROOF_DEFAULTS: ProofOptions = Object.freeze({ seconds: 60, leaves: 1000 });

const UNIT = 2 ** 20;
const SLACK = 1e-6;
/** Of each kind of branch that are tried before one is taken. */
const MOST_CANDIDATES = 5;
/** Weight of the side of a branch that proves more. */
const HIGHER_SIDE = 0.1;

/**
 * Proves how many beams and axles along lines any choice from these placements has at least, whatever
 * their layers are: HiGHS finds the minimum, and a tree of linear programmes over it says why there is no
 * less (docs/lower-bound.md). Nothing of the certificate has to be believed: each leaf's prices are whole
 * numbers, and their bound was added up exactly.
 */
export function prove(placements: Placements, highs: Highs, options = PROOF_DEFAULTS): Certificate {
  const programme = makeProgramme(placements);
  const pieces = piecesOf(programme);
  let leaves = 0;
  const proved = pieces.map((piece, done) => {
    const report = () => options.onProgress?.({ done, pieces: pieces.length, leaves });
    report();
    const onLeaf = () => {
      leaves += 1;
      report();
    };
    const linear = new LinearPiece(highs, programme, piece);
    try {
      const proof = new PieceProof(linear, programme, piece, { leaves: options.leaves, onLeaf });
      return proof.prove(minimumOf(highs, programme, piece, options.seconds));
    } finally {
      linear.dispose();
    }
  });
  return {
    format: 'liftarm-certificate',
    version: 1,
    name: placements.name,
    bound: proved.reduce((sum, { bound }) => sum + bound, 0),
    unit: UNIT,
    pieces: proved,
  };
}

/** The minimum of one piece as HiGHS sees it; where it takes too long, its lower bound. */
function minimumOf(highs: Highs, programme: Programme, piece: Piece, seconds: number): number {
  const useful = usefulColumns(programme, piece).map((c) => programme.columns[c] as Column);
  const place = new Map(piece.rows.map((row, i) => [row, i]));
  const starts = [0];
  const indices: number[] = [];
  const values: number[] = [];
  for (const column of useful) {
    indices.push(...column.rows.map((row) => place.get(row) as number));
    values.push(...column.factors);
    starts.push(indices.length);
  }
  const kept = piece.rows.map((row) => programme.rows[row]);
  const model = highs.createModel({
    numCols: useful.length,
    numRows: kept.length,
    colCost: useful.map(({ cost }) => cost),
    colLower: useful.map(() => 0),
    colUpper: useful.map(() => 1),
    rowLower: kept.map((row) => (row?.kind === 'most' ? Number.NEGATIVE_INFINITY : 1)),
    rowUpper: kept.map((row) => (row?.kind === 'most' ? row.most : Infinity)),
    matrix: {
      format: 'csc',
      numRows: kept.length,
      numCols: useful.length,
      starts,
      indices,
      values,
    },
    integrality: useful.map(() => 1 as const),
  });
  try {
    model.options.set({ output_flag: false, time_limit: seconds });
    model.run();
    return Math.ceil(Number(model.info.get('mip_dual_bound')) - SLACK);
  } finally {
    model.dispose();
  }
}

interface TreeLimits {
  readonly leaves: number;
  readonly onLeaf: () => void;
}

/** The tree of one piece. */
class PieceProof {
  readonly #programme: Programme;
  readonly #piece: Piece;
  readonly #linear: LinearPiece;
  readonly #branches: Branch[] = [];
  readonly #limits: TreeLimits;
  #leaves = 0;

  constructor(linear: LinearPiece, programme: Programme, piece: Piece, limits: TreeLimits) {
    this.#linear = linear;
    this.#programme = programme;
    this.#piece = piece;
    this.#limits = limits;
  }

  /** A tree for the target, or, where that takes too many leaves, one leaf for what it can prove. */
  prove(target: number): { bound: number; tree: ProofTree } {
    const root = this.#linear.solve();
    const leaf = this.#leafOf(root);
    const sure = Math.ceil(this.#exactBound(leaf) / UNIT);
    if (sure >= target || !Number.isFinite(target)) {
      return { bound: sure, tree: leaf };
    }
    const tree = this.#grow(target);
    return tree === null ? { bound: sure, tree: leaf } : { bound: target, tree };
  }

  /** The tree below the branches that are made; null when there are too many leaves. */
  #grow(target: number): ProofTree | null {
    const optimum = this.#linear.solve();
    const leaf = this.#leafOf(optimum);
    if (this.#exactBound(leaf) > UNIT * (target - 1)) {
      this.#leaves += 1;
      this.#limits.onLeaf();
      return leaf;
    }
    const rows = this.#branchingRows(optimum);
    if (rows === null || this.#leaves >= this.#limits.leaves) {
      return null;
    }
    const most = Math.floor(this.#sumOver(rows, optimum) + SLACK);
    const more = this.#below({ rows, sense: 'least', count: most + 1 }, target);
    const fewer = more && this.#below({ rows, sense: 'most', count: most }, target);
    return more && fewer && { rows, most, fewer, more };
  }

  #below(branch: Branch, target: number): ProofTree | null {
    this.#branches.push(branch);
    this.#linear.push(branch);
    const tree = this.#grow(target);
    this.#linear.pop();
    this.#branches.pop();
    return tree;
  }

  #sumOver(rows: readonly number[], { chosen }: LinearOptimum): number {
    let sum = 0;
    for (const [c, share] of chosen) {
      sum += isInAll(this.#programme.columns[c] as Column, rows) ? share : 0;
    }
    return sum;
  }

  /** The candidate whose two sides prove most; null where every choice is whole. */
  #branchingRows(optimum: LinearOptimum): readonly number[] | null {
    let best: readonly number[] | null = null;
    let bestScore = -1;
    for (const rows of this.#candidates(optimum)) {
      const most = Math.floor(this.#sumOver(rows, optimum) + SLACK);
      const fewer = this.#valueBelow({ rows, sense: 'most', count: most });
      const more = this.#valueBelow({ rows, sense: 'least', count: most + 1 });
      const score = Math.min(fewer, more) + HIGHER_SIDE * Math.max(fewer, more);
      if (score > bestScore) {
        best = rows;
        bestScore = score;
      }
    }
    return best;
  }

  #valueBelow(branch: Branch): number {
    this.#linear.push(branch);
    const { value } = this.#linear.solve();
    this.#linear.pop();
    return value;
  }

  /**
   * Rows of which it is open how many columns are in all of them, some that are most open: one row, or two,
   * or where these leave nothing open all rows of a column.
   */
  #candidates(optimum: LinearOptimum): (readonly number[])[] {
    const columns = [...optimum.chosen]
      .filter(([, share]) => share < 1 - SLACK)
      .map(([c]) => (this.#programme.columns[c] as Column).rows);
    const mostOpen = (candidates: readonly (readonly number[])[]) => {
      const seen = new Map(candidates.map((rows) => [rows.join(), rows]));
      return [...seen.values()]
        .map((rows) => ({ rows, openness: openness(this.#sumOver(rows, optimum)) }))
        .filter((candidate) => candidate.openness > 1e-4)
        .sort((a, b) => b.openness - a.openness)
        .slice(0, MOST_CANDIDATES)
        .map(({ rows }) => rows);
    };
    const some = [
      ...mostOpen(columns.flat().map((row) => [row])),
      ...mostOpen(columns.flatMap(pairsOf)),
    ];
    return some.length > 0 ? some : mostOpen(columns);
  }

  #leafOf({ prices, branchPrices }: LinearOptimum): Leaf {
    const whole = (price: number) => Math.floor(price * UNIT + 1e-3);
    return {
      prices: prices.flatMap((price, i) =>
        whole(price) > 0 ? [[this.#piece.rows[i] as number, whole(price)] as const] : [],
      ),
      branchPrices: branchPrices.map(whole),
    };
  }

  /** In units: what a leaf's prices prove, added up in whole numbers as the checker does. */
  #exactBound({ prices, branchPrices }: Leaf): number {
    const priceOf = new Map(prices);
    const { rows, columns } = this.#programme;
    let bound = 0;
    for (const [row, price] of prices) {
      const kept = rows[row];
      bound += kept?.kind === 'most' ? -kept.most * price : price;
    }
    this.#branches.forEach(({ sense, count }, i) => {
      bound += (sense === 'most' ? -count : count) * (branchPrices[i] ?? 0);
    });
    for (const c of this.#piece.columns) {
      const column = columns[c] as Column;
      let left = column.cost * UNIT;
      column.rows.forEach((row, k) => {
        const sign = rows[row]?.kind === 'most' ? -1 : 1;
        left -= sign * (column.factors[k] as number) * (priceOf.get(row) ?? 0);
      });
      this.#branches.forEach((branch, i) => {
        const price = branchPrices[i] ?? 0;
        if (price > 0 && isInAll(column, branch.rows)) {
          left += branch.sense === 'most' ? price : -price;
        }
      });
      bound += Math.min(0, left);
    }
    return bound;
  }
}

type Leaf = Extract<ProofTree, { prices: unknown }>;

/** How far from a whole number: from 0 to a half. */
function openness(sum: number): number {
  return Math.abs(sum - Math.round(sum));
}

function pairsOf(rows: readonly number[]): (readonly number[])[] {
  return rows.flatMap((a, i) => rows.slice(i + 1).map((b) => [a, b]));
}
