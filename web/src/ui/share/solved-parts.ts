import type { PlacedPart } from '../../model/model.ts';
import type { SketchDocument } from '../../model/sketch.ts';
import { writeSketch } from '../../state/read-sketch.ts';
import { roomSolver } from './room-solver.ts';

/** A model that the solver of the rooms found. */
export interface SolvedParts {
  readonly json: string;
  readonly parts: readonly PlacedPart[];
  readonly buildable: boolean;
}

/** Solves a sketch. @throws Error with one sentence when there is no model. */
export async function solveSketch(
  sketch: SketchDocument,
  settings: { readonly preset: string; readonly seed: number },
): Promise<SolvedParts> {
  const result = await roomSolver().solve(writeSketch(sketch), settings);
  if (result.outcome !== 'solved') {
    throw new Error(result.outcome === 'refused' ? result.message : result.outcome);
  }
  // The module's own text: its form is what the contract tests hold.
  const model = JSON.parse(result.modelJson) as { readonly parts: readonly PlacedPart[] };
  const report = JSON.parse(result.reportJson) as { readonly buildable?: boolean };
  return { json: result.modelJson, parts: model.parts, buildable: report.buildable ?? false };
}
