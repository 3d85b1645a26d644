import type { Catalogue } from '../../../model/catalogue.ts';
import {
  type BridgeContest,
  type BridgeScore,
  type LoadedState,
  placesOf,
  scoreBridge,
  truckLoads,
} from '../../../model/contest/bridge.ts';
import type { Model } from '../../../model/model.ts';
import type { CheckReport, Report } from '../../../model/report.ts';
import type { SketchDocument } from '../../../model/sketch.ts';
import type { PointLoad, StressAnswer } from '../../../model/stress.ts';
import { decodeShare } from '../../../share/codec.ts';
import { linkedPreferences } from '../../../share/shared-state.ts';
import type { SolverClient } from '../../../solver/worker-client.ts';
import { readSketchValue, writeSketch } from '../../../state/read-sketch.ts';
import { readSearchSettings } from '../../../state/search-settings.ts';
import { settingsOf } from '../../solve-settings.ts';
import type { Entry } from './entries.ts';
import type { Judged, NoScore } from './ranking.ts';
import { isSameDrawing } from './same-drawing.ts';

/** What counts: the fewest beams for one drawing, or the cheapest bridge that holds. */
export type Contest =
  | { readonly kind: 'beams'; readonly drawing: SketchDocument }
  | { readonly kind: 'bridge'; readonly rules: BridgeContest };

export interface Judge {
  readonly client: SolverClient;
  readonly catalogue: Catalogue;
  readonly signal: AbortSignal;
}

interface Verdict {
  readonly score: number | null;
  readonly fault: NoScore | null;
  readonly detail: string;
}

const noScore = (fault: NoScore, detail = ''): Verdict => ({ score: null, fault, detail });
const scored = (score: number): Verdict => ({ score, fault: null, detail: '' });

/** Makes the model of a link again and scores it, whatever its pupil says. Rejects only when it was stopped. */
export async function judgeEntry(entry: Entry, contest: Contest, judge: Judge): Promise<Judged> {
  try {
    return { entry, ...(await verdictOn(entry, contest, judge)) };
  } catch (error) {
    judge.signal.throwIfAborted();
    return { entry, ...noScore('failed', error instanceof Error ? error.message : String(error)) };
  }
}

async function verdictOn(entry: Entry, contest: Contest, judge: Judge): Promise<Verdict> {
  judge.signal.throwIfAborted();
  const shared = entry.fragment === null ? null : await decodeShare(entry.fragment);
  if (!shared?.ok) {
    return noScore('broken', shared?.message);
  }
  const sketch = readSketchValue(shared.value.sketch);
  const settings = readSearchSettings(linkedPreferences(shared.value));
  if (!sketch.ok || settings === null) {
    return noScore('broken', sketch.ok ? '' : sketch.message);
  }
  if (contest.kind === 'beams' && !isSameDrawing(contest.drawing, sketch.value)) {
    return noScore('otherDrawing');
  }
  const { client, signal } = judge;
  const result = await client.solve(writeSketch(sketch.value), settingsOf(settings), { signal });
  signal.throwIfAborted();
  if (result.outcome !== 'solved') {
    return noScore('refused', result.outcome === 'refused' ? result.message : '');
  }
  const checked = await client.check(result.modelJson, signal);
  if (checked.outcome !== 'ok' || !(JSON.parse(checked.text) as CheckReport).buildable) {
    return noScore('notBuildable');
  }
  if (contest.kind === 'beams') {
    const { beams = 0, axles = 0 } = JSON.parse(result.reportJson) as Report;
    return scored(beams + axles);
  }
  return bridgeVerdict(await loadBridge(result.modelJson, contest.rules, judge));
}

function bridgeVerdict({ score, worst }: BridgeScore): Verdict {
  if (score !== null) {
    return scored(score);
  }
  return noScore(worst.stands ? 'tooWeak' : 'folds', `${worst.front}`);
}

/** The truck in all its places, one question of the stress model each. */
async function loadBridge(
  modelJson: string,
  rules: BridgeContest,
  { client, catalogue, signal }: Judge,
): Promise<BridgeScore> {
  const states = new Map<string, LoadedState>();
  for (const front of placesOf(rules)) {
    const loads = truckLoads(rules, front);
    const optionsJson = JSON.stringify({ friction: 'held', loads });
    const asked = await client.ask({ about: 'stress', modelJson, optionsJson }, signal);
    if (asked.outcome === 'refused') {
      throw new Error(asked.message);
    }
    states.set(keyOf(loads), stateOf(JSON.parse(asked.text) as StressAnswer));
  }
  const { parts } = JSON.parse(modelJson) as Model;
  return scoreBridge(
    rules,
    parts.map(({ part }) => part),
    {
      massOf: (part) => catalogue.find(part)?.mass ?? 0,
      stressOf: (loads) =>
        states.get(keyOf(loads)) ?? { stands: false, safety: 0, displacement: 0 },
    },
  );
}

function keyOf(loads: readonly PointLoad[]): string {
  return JSON.stringify(loads);
}

function stateOf(answer: StressAnswer): LoadedState {
  return answer.ok
    ? { stands: true, safety: answer.safety, displacement: answer.maxDisplacement }
    : { stands: false, safety: 0, displacement: 0 };
}
