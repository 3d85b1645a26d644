import type { Catalogue } from '../../model/catalogue.ts';
import type { Model } from '../../model/model.ts';
import type { Report } from '../../model/report.ts';
import type { SolveSettings } from '../../solver/protocol.ts';
import type { SolverClient, SolveWatch } from '../../solver/worker-client.ts';
import { writeSketch } from '../../state/read-sketch.ts';
import type { LabSketch } from './lab-sketches.ts';

// A beam is taken out of the brick set, the model is made anew, and so on: the paper's test of brick sets, by hand.

/** A kind of beam with how often it is there. */
export interface BeamUse {
  readonly part: string;
  readonly count: number;
}

/** One model of the row, or the sentence why there is none. */
export interface AwayStep {
  /** Part numbers that are not there, in the order in which they were taken. */
  readonly without: readonly string[];
  readonly model: Model | null;
  readonly report: Report | null;
  readonly uses: readonly BeamUse[];
  readonly message: string;
}

/** Beams that cover something, most used first, the lower number of equals. */
export function beamUses(model: Model, catalogue: Catalogue): BeamUse[] {
  const counts = new Map<string, number>();
  for (const { part } of model.parts) {
    const known = catalogue.find(part);
    if (known?.partClass === 'beam' && known.stretches.length > 0) {
      counts.set(part, (counts.get(part) ?? 0) + 1);
    }
  }
  return [...counts]
    .map(([part, count]) => ({ part, count }))
    .sort((a, b) => b.count - a.count || (a.part < b.part ? -1 : 1));
}

/** What the search is told; as `npm run experiments brick-sets` does. */
export function settingsWithout(without: readonly string[]): SolveSettings {
  return {
    seed: 1,
    preset: 'simple',
    set: Object.fromEntries(without.map((id) => [`owned.${id}`, 0])),
  };
}

/** @returns null when it was stopped. */
async function makeWithout(
  client: SolverClient,
  asked: {
    readonly sketch: LabSketch;
    readonly without: readonly string[];
    readonly catalogue: Catalogue;
  },
  watch: SolveWatch,
): Promise<AwayStep | null> {
  const { sketch, without, catalogue } = asked;
  const result = await client.solve(writeSketch(sketch.sketch), settingsWithout(without), watch);
  if (result.outcome === 'cancelled') {
    return null;
  }
  if (result.outcome === 'refused') {
    return { without, model: null, report: null, uses: [], message: result.message };
  }
  const model = JSON.parse(result.modelJson) as Model;
  const report = JSON.parse(result.reportJson) as Report;
  return { without, model, report, uses: beamUses(model, catalogue), message: '' };
}

export interface AwayAsked {
  readonly sketch: LabSketch;
  readonly catalogue: Catalogue;
  /** What is not there already. */
  readonly without: readonly string[];
  /** What is taken now; null: nothing, for the first model. */
  readonly part: string | null;
  /** Goes on with the most used beam of each model until none is left. */
  readonly all: boolean;
}

export interface AwayWatch {
  readonly onBegin: (without: readonly string[]) => void;
  readonly onStep: (step: AwayStep) => void;
  readonly signal: AbortSignal;
}

/** One model after the other, each told of at once. @returns false when it was stopped. */
export async function makeRow(
  client: SolverClient,
  { sketch, catalogue, without, part, all }: AwayAsked,
  { onBegin, onStep, signal }: AwayWatch,
): Promise<boolean> {
  const out = part === null ? [...without] : [...without, part];
  for (;;) {
    onBegin(out);
    const asked = { sketch, catalogue, without: [...out] };
    const step = await makeWithout(client, asked, { signal });
    if (step === null) {
      return false;
    }
    onStep(step);
    const next = step.uses[0]?.part;
    if (!all || next === undefined) {
      return true;
    }
    out.push(next);
  }
}
