import Papa from 'papaparse';
import type { Run } from './race.ts';
import { gapsOf } from './race.ts';

/** What a run ended with. */
export interface RaceResult {
  readonly sketch: string;
  readonly method: string;
  /** Sum of the lines, modules. */
  readonly length: number;
  readonly beams: number;
  readonly bricks: number;
  readonly gaps: number;
  readonly collisions: number;
  readonly failedConnections: number;
  readonly buildable: boolean;
  /** Depends on the machine, unlike all others. */
  readonly seconds: number;
}

/** Of the runs that have ended by themselves, in their order. */
export function resultsOf(runs: readonly Run[]): RaceResult[] {
  return runs.flatMap(({ sketch, method, state }) => {
    const { report, seconds } = state.value;
    if (report === null || seconds === null) {
      return [];
    }
    const { length = 0, beams = 0, axles = 0, bricks = 0, collisions = 0 } = report;
    return [
      {
        sketch: sketch.id,
        method,
        length,
        beams: beams + axles,
        bricks,
        gaps: gapsOf(report),
        collisions,
        failedConnections: report.failedConnections ?? 0,
        buildable: report.buildable === true,
        seconds,
      },
    ];
  });
}

/** A table for other programs; seconds come last, since they alone differ from machine to machine. */
export function csvOf(results: readonly RaceResult[]): string {
  const rows = results.map((one) => ({
    ...one,
    buildable: one.buildable ? 'yes' : 'no',
    seconds: one.seconds.toFixed(3),
  }));
  return `${Papa.unparse(rows, { newline: '\n' })}\n`;
}

/** The exponent of y = factor * x^exponent, by least squares of logarithms; null with less than three different x. */
export function exponentOf(
  points: readonly { readonly x: number; readonly y: number }[],
): number | null {
  const logs = points
    .filter(({ x, y }) => x > 0 && y > 0)
    .map(({ x, y }) => [Math.log(x), Math.log(y)] as const);
  if (new Set(logs.map(([u]) => u)).size < 3) {
    return null;
  }
  const mean = (of: (log: readonly [number, number]) => number) =>
    logs.reduce((sum, log) => sum + of(log), 0) / logs.length;
  const u = mean(([x]) => x);
  const v = mean(([, y]) => y);
  return mean(([x, y]) => (x - u) * (y - v)) / mean(([x]) => (x - u) ** 2);
}
