import { type Signal, signal } from '@preact/signals';
import type { Model } from '../../model/model.ts';
import type { Report } from '../../model/report.ts';
import type { SolveProgress, SolveSettings } from '../../solver/protocol.ts';
import type { SolveResult, SolverClient } from '../../solver/worker-client.ts';
import { writeSketch } from '../../state/read-sketch.ts';
import type { LabSketch } from './lab-sketches.ts';
import type { MethodId } from './race-plan.ts';

/** A moment of a search, for the curves. */
export interface RacePoint {
  /** Since the search began. */
  readonly seconds: number;
  readonly objective: number;
  readonly beams: number;
  readonly gaps: number;
  readonly faults: number;
}

export type RunPhase = 'waiting' | 'running' | 'done' | 'stopped' | 'refused' | 'failed';

export interface RunState {
  readonly phase: RunPhase;
  /** 0 to 1. */
  readonly fraction: number;
  readonly points: readonly RacePoint[];
  /** The best so far. */
  readonly model: Model | null;
  /** Of a search that has ended by itself. */
  readonly report: Report | null;
  /** Inside the module. */
  readonly seconds: number | null;
  /** Why it was refused, or failed. */
  readonly message: string;
}

/** One method on one sketch. */
export interface Run {
  readonly key: string;
  readonly sketch: LabSketch;
  readonly method: MethodId;
  readonly settings: SolveSettings;
  readonly state: Signal<RunState>;
}

const WAITING: RunState = Object.freeze({
  phase: 'waiting',
  fraction: 0,
  points: [],
  model: null,
  report: null,
  seconds: null,
  message: '',
});

/** Curves and bars move so often. */
const SHOW_MS = 150;
/** A picture of a model takes a while to draw: no run shows more than so many a second. */
const PICTURE_MS = 400;
/** Points of a curve; when there are twice as many, every other one goes. */
const MAX_POINTS = 300;

export function newRun(sketch: LabSketch, method: MethodId, settings: SolveSettings): Run {
  const key = `${sketch.id}/${method}`;
  return { key, sketch, method, settings, state: signal(WAITING) };
}

export interface RaceOptions {
  /** How many race at a time, each in a worker of its own. */
  readonly lanes: number;
  readonly createClient: () => SolverClient;
  /** Milliseconds. */
  readonly now: () => number;
}

/** Makes all runs, the next as soon as a lane is free; resolves when each has ended or the race is stopped. Never rejects. */
export async function race(
  runs: readonly Run[],
  options: RaceOptions,
  signalOfStop: AbortSignal,
): Promise<void> {
  const queue = [...runs];
  const lane = async (): Promise<void> => {
    const client = options.createClient();
    await warmUp(client, queue[0], signalOfStop);
    for (let run = queue.shift(); run; run = queue.shift()) {
      await makeRun(run, client, options, signalOfStop);
    }
    client.dispose();
  };
  const lanes = Math.min(options.lanes, runs.length);
  await Promise.all(Array.from({ length: lanes }, lane));
}

/** Loads the module and what every search needs once: no method should pay for it by coming first. */
async function warmUp(client: SolverClient, run: Run | undefined, signalOfStop: AbortSignal) {
  if (run) {
    const sketchJson = writeSketch(run.sketch.sketch);
    const question = { about: 'opens', sketchJson, settings: run.settings } as const;
    // What is wrong with it shows in the run itself.
    await client.ask(question, signalOfStop).catch(() => null);
  }
}

async function makeRun(
  { sketch, settings, state }: Run,
  client: SolverClient,
  { now }: RaceOptions,
  signalOfStop: AbortSignal,
): Promise<void> {
  const set = (change: Partial<RunState>) => {
    state.value = { ...state.peek(), ...change };
  };
  if (signalOfStop.aborted) {
    set({ phase: 'stopped' });
    return;
  }
  const begun = now();
  let pictureAt = begun;
  let showAt = begun;
  set({ phase: 'running' });
  const onProgress = (progress: SolveProgress, modelJson: string | null) => {
    const at = now();
    const point = pointOf(progress, (at - begun) / 1000);
    const due = modelJson !== null && at >= pictureAt;
    if (!due && at < showAt) {
      return;
    }
    showAt = at + SHOW_MS;
    if (due) {
      pictureAt = at + PICTURE_MS;
    }
    set({
      fraction: progress.fraction,
      points: thinned([...state.peek().points, point]),
      ...(due ? { model: JSON.parse(modelJson) as Model } : {}),
    });
  };
  try {
    const asked = { onProgress, signal: signalOfStop };
    set(ending(await client.solve(writeSketch(sketch.sketch), settings, asked), state.peek()));
  } catch (error) {
    set({ phase: 'failed', message: error instanceof Error ? error.message : String(error) });
  }
}

/** How the end of a search changes the state of its run. */
function ending(result: SolveResult, before: RunState): Partial<RunState> {
  if (result.outcome === 'refused') {
    return { phase: 'refused', message: result.message };
  }
  if (result.outcome === 'cancelled') {
    return { phase: 'stopped' };
  }
  const report = JSON.parse(result.reportJson) as Report;
  const { total } = result.seconds;
  const last = lastPoint(report, before.points.at(-1)?.seconds ?? total);
  return {
    phase: 'done',
    fraction: 1,
    model: JSON.parse(result.modelJson) as Model,
    report,
    seconds: total,
    points: [...before.points, last],
  };
}

function pointOf(progress: SolveProgress, seconds: number): RacePoint {
  const { objective, beams, gaps, collisions, failedConnections } = progress;
  return { seconds, objective, beams, gaps, faults: gaps + collisions + failedConnections };
}

function lastPoint(report: Report, seconds: number): RacePoint {
  const { objective = 0, beams = 0, axles = 0, collisions = 0, failedConnections = 0 } = report;
  const gaps = gapsOf(report);
  return {
    seconds,
    objective,
    beams: beams + axles,
    gaps,
    faults: (report.gaps ?? 0) + collisions + failedConnections,
  };
}

/** Gaps as the paper counts them: whether or not a spacer fills them. */
export function gapsOf({ gaps = 0, filledGaps = 0 }: Report): number {
  return gaps + filledGaps;
}

/** Of a long curve every other point, and its last. */
export function thinned<T>(points: readonly T[]): readonly T[] {
  return points.length <= 2 * MAX_POINTS
    ? points
    : points.filter((_, i) => i % 2 === 0 || i === points.length - 1);
}
