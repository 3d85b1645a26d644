import type { Report } from '../model/report.ts';

/** What decides between the results of several seeds. */
export interface Standing {
  readonly buildable: boolean;
  /** Gaps, collisions, uncovered edges and failed connections. */
  readonly violations: number;
  readonly beams: number;
  readonly bricks: number;
  readonly objective: number;
  readonly seed: number;
}

/** The standing of a report; keys that are missing count as 0. */
export function standingOf(report: Report): Standing {
  const { gaps = 0, collisions = 0, uncovered = 0, failedConnections = 0 } = report;
  return {
    buildable: report.buildable ?? false,
    violations: gaps + collisions + uncovered + failedConnections,
    beams: report.beams ?? 0,
    bricks: report.bricks ?? 0,
    objective: report.objective ?? 0,
    seed: report.seed ?? 0,
  };
}

/**
 * Whether a goes before b: buildable before not, then fewer violations, beams, bricks, then the lower
 * objective, then the lower seed. The command has the same rule (core/cli/best_of.h);
 * tests/contract/best-of.json holds both to it.
 */
export function isBetter(a: Standing, b: Standing): boolean {
  if (a.buildable !== b.buildable) {
    return a.buildable;
  }
  const keys = ['violations', 'beams', 'bricks', 'objective', 'seed'] as const;
  const differing = keys.find((key) => a[key] !== b[key]);
  return differing !== undefined && a[differing] < b[differing];
}
