/** Beams that are one part, by their number of holes. */
const ONE_PART: readonly number[] = [2, 3, 5, 7, 9, 11, 13, 15];
/** Those that are two thin ones. */
const TWO_THIN: readonly number[] = [4, 6];

/** What a line of a length alone would be built of. */
export type BeamKind = 'one' | 'thin' | 'several';

/** @param length modules, whole. A line of 6 has 7 nodes: a beam of 7 holes. */
export function beamFor(length: number): { readonly kind: BeamKind; readonly holes: number } {
  const holes = Math.round(length) + 1;
  const kind = ONE_PART.includes(holes) ? 'one' : TWO_THIN.includes(holes) ? 'thin' : 'several';
  return { kind, holes };
}
