import type { Model } from '../../model/model.ts';
import type { CheckReport, Report } from '../../model/report.ts';
import type { SketchDocument } from '../../model/sketch.ts';
import type { MadeModel } from '../../solver/made-model.ts';
import type { SolveSettings } from '../../solver/protocol.ts';
import { createSolverPool } from '../../solver/solver-pool.ts';
import type { SolverClient } from '../../solver/worker-client.ts';
import { writeSketch } from '../../state/read-sketch.ts';
import { type Candidate, type Figures, figuresOf, modelText } from './alternatives.ts';

/** One model of the drawing that may be taken. */
export interface Alternative extends MadeModel {
  readonly candidate: Candidate;
  readonly model: Model;
  readonly figures: Figures;
}

/** What is asked. */
export interface Asked<C extends Candidate = Candidate> {
  readonly sketch: SketchDocument;
  readonly candidates: readonly C[];
  /** What the search is told for one of them. */
  readonly settingsOf: (candidate: C) => SolveSettings;
}

let pool: SolverClient | null = null;

/** Workers of their own: a search of the drawing does not wait for them. */
export function alternativesSolver(): SolverClient {
  pool ??= createSolverPool();
  return pool;
}

export interface AlternativesWatch {
  /** modelText() of a model that is no alternative to itself. */
  readonly known: string | null;
  /** Told of each at once. */
  readonly onFound: (found: Alternative) => void;
  /** A search is over, whatever came of it. */
  readonly onTried: () => void;
  readonly signal: AbortSignal;
}

/** Searches for one model after the other; a model that was found before is left out. */
export async function findAlternatives(
  client: SolverClient,
  asked: Asked,
  watch: AlternativesWatch,
): Promise<void> {
  const { known, onFound, onTried, signal } = watch;
  const seen = new Set(known === null ? [] : [known]);
  for (const candidate of asked.candidates) {
    const found = signal.aborted ? null : await searchOne(client, asked, candidate, signal);
    if (found && !signal.aborted && !seen.has(modelText(found.model))) {
      seen.add(modelText(found.model));
      onFound(found);
    }
    if (!signal.aborted) {
      onTried();
    }
  }
}

/** @returns null where it is refused or cancelled. */
export async function searchOne<C extends Candidate>(
  client: SolverClient,
  { sketch, settingsOf }: Asked<C>,
  candidate: C,
  signal: AbortSignal,
): Promise<Alternative | null> {
  const settings = settingsOf(candidate);
  const result = await client.solve(writeSketch(sketch), settings, { signal });
  if (result.outcome !== 'solved') {
    return null;
  }
  const model = JSON.parse(result.modelJson) as Model;
  const checked = await client.check(result.modelJson, signal).catch(() => null);
  if (checked?.outcome !== 'ok') {
    return null;
  }
  const { modelJson, reportJson, layoutJson } = result;
  const figures = figuresOf(
    model,
    JSON.parse(reportJson) as Report,
    JSON.parse(checked.text) as CheckReport,
  );
  const found = { sketch, settings, modelJson, reportJson, layoutJson, checkJson: checked.text };
  return { ...found, candidate, model, figures };
}
