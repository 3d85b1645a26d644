/** A path that a linkage is asked for. */
export interface EvaluatedPath {
  readonly name: string;
  readonly kind: string;
  readonly closed: boolean;
  readonly points: readonly (readonly number[])[];
}

export function linkagePaths(seed?: number): EvaluatedPath[];
export function pathText(path: EvaluatedPath): string;
