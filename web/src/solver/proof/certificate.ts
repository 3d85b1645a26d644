/**
 * Why a bound holds, for anybody to check without us (scripts/check-certificate.mjs, docs/lower-bound.md).
 * Prices are whole numbers in units of 1 / `unit`; rows are numbered as in programme.ts.
 */
export interface Certificate {
  readonly format: 'liftarm-certificate';
  readonly version: 1;
  readonly name: string;
  /** At least so many beams and axles along lines. */
  readonly bound: number;
  readonly unit: number;
  /** Pieces that share no cover; their bounds add up to `bound`. */
  readonly pieces: readonly { readonly bound: number; readonly tree: ProofTree }[];
}

export type ProofTree = ProofLeaf | ProofBranch;

/** Prices that prove the bound where all branches above hold. */
export interface ProofLeaf {
  /** Row and its price. */
  readonly prices: readonly (readonly [number, number])[];
  /** One price for each branch above, the outermost first. */
  readonly branchPrices: readonly number[];
}

/** Of the covers that are in all these rows either at most `most` are chosen, or more. */
export interface ProofBranch {
  readonly rows: readonly number[];
  readonly most: number;
  readonly fewer: ProofTree;
  readonly more: ProofTree;
}
