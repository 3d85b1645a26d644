import { countParts } from '../../model/counts.ts';
import type { Model } from '../../model/model.ts';
import type { CheckReport, Report } from '../../model/report.ts';
import type { SearchSettings } from '../../state/search-settings.ts';
import { PRESETS } from '../../state/search-settings.ts';

// Several models of one drawing: what is searched for, which of them are the same, and which is the best in what.

/** What one alternative is searched with, beside what the person has set. */
export interface Candidate {
  readonly id: string;
  readonly preset: string;
  readonly seed: number;
}

/** Far from the seeds that a search tries by itself when its first one fails. */
const OTHER_SEED = 1000;

/** What a person asks of several models; the order of the columns of the table. */
export const FIGURES = ['bricks', 'kinds', 'deviation', 'freedoms', 'mass'] as const;
export type FigureId = (typeof FIGURES)[number];

export interface Figures extends Readonly<Record<FigureId, number | null>> {
  readonly buildable: boolean;
  /** How many of so many items a builder would expect (DESIGN 5b). */
  readonly wellBuilt: readonly [passed: number, of: number] | null;
}

/** The presets other than the one in force, and that one with another seed. */
export function candidates({ preset, seed }: Pick<SearchSettings, 'preset' | 'seed'>): Candidate[] {
  return [
    { id: preset, preset, seed },
    ...PRESETS.filter((other) => other !== preset).map((other) => ({
      id: other,
      preset: other,
      seed,
    })),
    { id: 'other', preset, seed: seed + OTHER_SEED },
  ];
}

/** Equal texts, equal models: every part with its place. */
export function modelText({ parts }: Model): string {
  const placed = parts.map(({ part, position, rotation }) =>
    [
      part,
      ...[...position, ...rotation].map((x) => (Math.round(x * 100) / 100 + 0).toFixed(2)),
    ].join(' '),
  );
  return placed.sort().join('\n');
}

export function figuresOf(model: Model, report: Report, check: CheckReport): Figures {
  const { deviation, freedoms, mass } = report;
  const { wellBuilt } = check;
  return {
    bricks: model.parts.length,
    kinds: new Set(countParts(model).map(({ part }) => part)).size,
    deviation: deviation ?? null,
    freedoms: freedoms ?? null,
    mass: mass ?? null,
    buildable: check.buildable,
    wellBuilt: wellBuilt ? [wellBuilt.passed, wellBuilt.of] : null,
  };
}

/**
 * In what each of some models is the best: the least of a figure, where they differ in it at all. One that cannot be
 * built is the best in nothing.
 */
export function bestIn(all: readonly Figures[]): ReadonlySet<FigureId>[] {
  const best = all.map(() => new Set<FigureId>());
  for (const figure of FIGURES) {
    const known = all.flatMap((one) => {
      const value = one[figure];
      return one.buildable && value !== null ? [value] : [];
    });
    const least = Math.min(...known);
    if (known.length > 1 && least < Math.max(...known)) {
      all.forEach((one, i) => {
        if (one.buildable && one[figure] === least) {
          best[i]?.add(figure);
        }
      });
    }
  }
  return best;
}
