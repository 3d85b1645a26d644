import type { Entry } from './entries.ts';

/** Why an entry has no score. */
export type NoScore =
  | 'broken'
  | 'otherDrawing'
  | 'refused'
  | 'notBuildable'
  | 'folds'
  | 'tooWeak'
  | 'failed';

/** What the judge found of an entry. */
export interface Judged {
  readonly entry: Entry;
  /** The less the better; null for one that has none. */
  readonly score: number | null;
  readonly fault: NoScore | null;
  /** More about the fault, in words. */
  readonly detail: string;
}

export interface Ranked extends Judged {
  /** From 1 on, equal scores share it; null without a score. */
  readonly place: number | null;
  /** The pupil says another score than the judge finds. */
  readonly wrongClaim: boolean;
}

/** A claim is rounded as the page shows scores. */
const TOLERANCE = 0.005;

/** Least score first; those without one in the order in which they came. */
export function ranked(judged: readonly Judged[]): Ranked[] {
  const scores = judged.flatMap(({ score }) => (score === null ? [] : [score]));
  const rows = judged.map((one): Ranked => {
    const { score, entry } = one;
    const { claimed } = entry;
    return {
      ...one,
      place: score === null ? null : 1 + scores.filter((other) => other < score).length,
      wrongClaim: claimed !== null && (score === null || Math.abs(claimed - score) > TOLERANCE),
    };
  });
  const last = judged.length + 1;
  return rows.sort((a, b) => (a.place ?? last) - (b.place ?? last));
}
