/**
 * Every part in every place that the search may lay, without layers: the answer of `liftarm placements`
 * (core/design/placements.h). What a proof says is said about these.
 */
export interface Placements {
  readonly format: 'liftarm-placements';
  readonly version: 1;
  readonly name: string;
  readonly runs: readonly unknown[];
  /** Unit edges that some part must cover. */
  readonly edges: readonly { readonly run: number; readonly index: number }[];
  readonly covers: readonly PlacedCover[];
  /** Covers of which at most one can be there. */
  readonly rivals: readonly (readonly number[])[];
  readonly limits: readonly { readonly part: string; readonly owned: number }[];
  readonly quickBound: number;
}

export interface PlacedCover {
  readonly kind: 'straight' | 'bent' | 'frame' | 'axle';
  /** LDraw number. */
  readonly part: string;
  /** Real parts that it is made of. */
  readonly parts: number;
  readonly runs: readonly number[];
  readonly edges: readonly number[];
}

/** The text is our own core's; tests/contract checks its fields. */
export function readPlacements(text: string): Placements {
  return JSON.parse(text) as Placements;
}
