import type { Report } from '../model/report.ts';
import { isBetter, type Standing, standingOf } from './best-of.ts';
import { createSolverClient } from './client.ts';
import { ClientPark } from './client-park.ts';
import type { SolveProgress, SolveSettings } from './protocol.ts';
import type { SolveResult, SolverClient, SolveWatch } from './worker-client.ts';

/**
 * Several seeds at once, in a worker each. A solve tries the seeds s, s + 1, ... and ends with the first of
 * them that is buildable, or after all with the best (best-of.ts). Which that is does not depend on the
 * number of workers: seeds are tried ahead of their turn, never instead of it.
 */

export interface PoolOptions {
  readonly workers: number;
  /** Seeds that a solve tries at most. */
  readonly seeds: number;
  /** Milliseconds that the first seed has for itself: most sketches need no second one. */
  readonly patienceMs: number;
  readonly createClient: () => SolverClient;
}

const MAX_WORKERS = 4;
const DEFAULT_SEED = 1;

/** Leaves one core to the page. */
export function workersFor(cores: number): number {
  return Math.max(1, Math.min(MAX_WORKERS, cores - 1));
}

function defaults(): PoolOptions {
  return {
    workers: workersFor(globalThis.navigator?.hardwareConcurrency ?? 1),
    seeds: 4,
    patienceMs: 1500,
    createClient: createSolverClient,
  };
}

export function createSolverPool(options: Partial<PoolOptions> = {}): SolverClient {
  const chosen = { ...defaults(), ...options };
  // One more than search at once: the check of a large model takes a while, and a new search must not
  // wait for it.
  const park = new ClientPark(chosen.createClient, chosen.workers + 1);
  return {
    solve: (sketchJson, settings, watch = {}) =>
      new SeedRace(chosen, park, { sketchJson, settings, watch }).run(),
    check: (...asked) => park.free().check(...asked),
    exportModel: (...asked) => park.free().exportModel(...asked),
    ask: (...asked) => park.free().ask(...asked),
    warmUp: () => park.free().warmUp(),
    dispose: () => park.dispose(),
  };
}

interface Request {
  readonly sketchJson: string;
  readonly settings: SolveSettings;
  readonly watch: SolveWatch;
}

interface Solved {
  readonly result: Extract<SolveResult, { outcome: 'solved' }>;
  readonly standing: Standing;
}

/** One seed under way: what it showed last. */
interface Seed {
  progress: SolveProgress | null;
  model: string | null;
}

/** One solve over several seeds. Settles exactly once. */
class SeedRace {
  readonly #options: PoolOptions;
  readonly #park: ClientPark;
  readonly #request: Request;
  readonly #stop = new AbortController();
  readonly #seeds: Seed[];
  readonly #solved: (Solved | undefined)[];
  #next = 0;
  #shown: string | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #settle: (result: SolveResult) => void = () => undefined;
  #fail: (error: unknown) => void = () => undefined;

  constructor(options: PoolOptions, park: ClientPark, request: Request) {
    this.#options = options;
    this.#park = park;
    this.#request = request;
    this.#seeds = Array.from({ length: options.seeds }, () => ({ progress: null, model: null }));
    this.#solved = new Array<Solved | undefined>(options.seeds).fill(undefined);
  }

  run(): Promise<SolveResult> {
    const { signal } = this.#request.watch;
    return new Promise<SolveResult>((resolve, reject) => {
      const cancel = () => this.#settle({ outcome: 'cancelled', modelJson: this.#shown });
      const end = () => {
        clearTimeout(this.#timer);
        signal?.removeEventListener('abort', cancel);
        this.#stop.abort();
      };
      this.#settle = (result) => {
        end();
        resolve(result);
      };
      this.#fail = (error) => {
        end();
        reject(error);
      };
      if (signal?.aborted) {
        cancel();
        return;
      }
      signal?.addEventListener('abort', cancel);
      this.#startNext();
      this.#timer = setTimeout(() => this.#startOthers(), this.#options.patienceMs);
    });
  }

  #startOthers(): void {
    for (let i = 1; i < this.#options.workers; i += 1) {
      this.#startNext();
    }
  }

  /** Gives the next seed to a worker that is free; none when all are under way. */
  #startNext(): void {
    const index = this.#next;
    if (index >= this.#options.seeds || this.#stop.signal.aborted) {
      return;
    }
    this.#next += 1;
    const { sketchJson, settings } = this.#request;
    const watch: SolveWatch = {
      onProgress: (progress, model) => this.#progressed(index, progress, model),
      signal: this.#stop.signal,
    };
    this.#park
      .free()
      .solve(sketchJson, settingsOfTry(settings, index), watch)
      .then((result) => this.#ended(index, result))
      .catch((error: unknown) => this.#fail(error));
  }

  #ended(index: number, result: SolveResult): void {
    if (this.#stop.signal.aborted) {
      return;
    }
    if (result.outcome !== 'solved') {
      // What one seed refuses all refuse; a worker that cancels by itself was closed.
      this.#settle(result);
      return;
    }
    this.#solved[index] = { result, standing: standingOf(readReport(result.reportJson)) };
    const winner = decide(this.#solved);
    if (winner !== null) {
      this.#settle(winner.result);
      return;
    }
    this.#startNext();
  }

  /** Tells of all seeds together, and shows the model of the one that leads. */
  #progressed(index: number, progress: SolveProgress, model: string | null): void {
    const seed = this.#seeds[index];
    if (seed === undefined || this.#stop.signal.aborted) {
      return;
    }
    seed.progress = progress;
    seed.model = model ?? seed.model;
    const leader = leaderOf(this.#seeds);
    if (leader?.progress == null) {
      return;
    }
    const news = leader.model !== this.#shown ? leader.model : null;
    this.#shown = leader.model ?? this.#shown;
    const iterations = this.#seeds.reduce((sum, { progress: p }) => sum + (p?.iterations ?? 0), 0);
    this.#request.watch.onProgress?.({ ...leader.progress, iterations }, news);
  }
}

/**
 * What the try of this number is asked: seed s + number. What grows from an earlier layout has one try;
 * when that does not end buildable the others are those of a search without it.
 */
export function settingsOfTry(settings: SolveSettings, index: number): SolveSettings {
  const { earlier, seed = DEFAULT_SEED, ...others } = settings;
  if (earlier === undefined) {
    return { ...others, seed: seed + index };
  }
  return index === 0 ? { ...others, seed, earlier } : { ...others, seed: seed + index - 1 };
}

/** The text is our own module's: tests/contract checks its fields. */
function readReport(json: string): Report {
  return JSON.parse(json) as Report;
}

/** The result that the seeds so far decide on, or null while an earlier one is still open. */
export function decide<T extends { readonly standing: Standing }>(
  solved: readonly (T | undefined)[],
): T | null {
  let best: T | null = null;
  for (const one of solved) {
    if (one === undefined) {
      return null;
    }
    if (one.standing.buildable) {
      return one;
    }
    best = best === null || isBetter(one.standing, best.standing) ? one : best;
  }
  return best;
}

/** The seed that has come farthest: fewest violations, then beams, then the first. */
function leaderOf(seeds: readonly Seed[]): Seed | null {
  const rank = ({ progress }: Seed): readonly number[] =>
    progress === null
      ? [Number.POSITIVE_INFINITY]
      : [progress.gaps + progress.collisions + progress.failedConnections, progress.beams];
  let leader: Seed | null = null;
  for (const seed of seeds) {
    if (leader === null || isLess(rank(seed), rank(leader))) {
      leader = seed;
    }
  }
  return leader;
}

function isLess(a: readonly number[], b: readonly number[]): boolean {
  const i = a.findIndex((value, k) => value !== b[k]);
  const [left, right] = [a[i], b[i]];
  return left !== undefined && right !== undefined && left < right;
}
