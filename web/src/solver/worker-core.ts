import { assertNever } from '../base/assert-never.ts';
import type {
  FromWorker,
  OpensQuestion,
  Question,
  SolveProgress,
  SolveSettings,
  ToWorker,
} from './protocol.ts';
import type { SolverModule, SolverReply, SolverSession } from './solver-module.ts';

/**
 * The worker's logic without a worker: plain functions over the module and a host, so that tests drive it
 * in Node. The module cannot be called while it is busy, so a search runs in slices of some milliseconds;
 * between them the host takes its messages. How the work is sliced never changes its result.
 */

/** What surrounds the core: a real worker, or a test. */
export interface WorkerHost {
  post(reply: FromWorker): void;
  /** Milliseconds, monotonic. */
  now(): number;
  /** Resolves after messages that wait have been taken. */
  pause(): Promise<void>;
  /** The last line that the module wrote to stderr. */
  lastWords(): string;
}

export interface WorkerCore {
  /** Treats one message; resolves when its job has ended. Never rejects. */
  handle(message: ToWorker): Promise<void>;
}

/** Milliseconds of one slice: short against a cancel, long against the cost of a message. */
const SLICE_MS = 25;
const PROGRESS_EVERY_MS = 80;
const MODEL_EVERY_MS = 200;
const FIRST_SLICE_ITERATIONS = 64;
const MAX_SLICE_ITERATIONS = 1 << 24;

type Request = Exclude<ToWorker, { kind: 'cancel' }>;

/** Ends a job before its time: what it throws is not a crash. */
class Refusal extends Error {}

export function createWorkerCore(loading: Promise<SolverModule>, host: WorkerHost): WorkerCore {
  const cancelled = new Set<number>();
  const solving = new Set<number>();

  const answer = async (request: Request): Promise<FromWorker> => {
    const { jobId } = request;
    const module = await loading;
    switch (request.kind) {
      case 'start':
        return runSearch(module, host, request, () => cancelled.has(jobId));
      case 'check':
        return {
          kind: 'checked',
          jobId,
          checkJson: textOf(module.checkModelJson(request.modelJson)),
        };
      case 'export':
        return {
          kind: 'exported',
          jobId,
          text: textOf(module.exportModel(request.modelJson, request.format)),
        };
      case 'ask':
        return { kind: 'answered', jobId, text: textOf(answerTo(module, request.question)) };
      default:
        return assertNever(request);
    }
  };

  const handle = async (message: ToWorker): Promise<void> => {
    const { jobId } = message;
    if (message.kind === 'cancel') {
      if (solving.has(jobId)) {
        cancelled.add(jobId);
      }
      return;
    }
    if (message.kind === 'start') {
      solving.add(jobId);
    }
    try {
      host.post(await answer(message));
    } catch (error) {
      host.post(
        error instanceof Refusal
          ? { kind: 'refused', jobId, message: error.message }
          : { kind: 'failed', jobId, message: describeCrash(error, host.lastWords()) },
      );
    } finally {
      solving.delete(jobId);
      cancelled.delete(jobId);
    }
  };
  return { handle };
}

function answerTo(module: SolverModule, question: Question): SolverReply {
  switch (question.about) {
    case 'symmetries':
      return module.findSymmetriesJson(question.sketchJson);
    case 'opens':
      return openedBy(module, question);
    case 'placements':
      return module.placementsJson(question.sketchJson, settingsText(question.settings));
    case 'places':
      return module.partPlacesJson(
        question.modelJson,
        question.layoutJson,
        settingsText(question.settings),
      );
    case 'fits':
      return module.fittingPartsJson(
        question.modelJson,
        question.layoutJson,
        settingsText(question.settings),
        question.part,
      );
    case 'stress':
      return module.analyseStressJson(question.modelJson, question.optionsJson);
    case 'motion':
      return module.analyseMotionJson(question.modelJson);
    case 'path':
      return question.of === 'joint'
        ? module.jointMotionJson(question.modelJson, question.index)
        : module.freeMotionJson(question.modelJson, question.index);
    default:
      return assertNever(question);
  }
}

/** Opens a search and gives it up at once: what is refused is refused then. */
function openedBy(module: SolverModule, { sketchJson, settings }: OpensQuestion): SolverReply {
  const session = new module.SolverSession(sketchJson, settingsText(settings));
  try {
    return session.opened();
  } finally {
    session.delete();
  }
}

function textOf({ status, text }: { readonly status: string; readonly text: string }): string {
  if (status !== 'ok') {
    throw new Refusal(text);
  }
  return text;
}

/** A C++ exception arrives without its text; a failed check has said its place on stderr. */
function describeCrash(error: unknown, lastWords: string): string {
  const text = error instanceof Error ? error.message : 'the solver stopped unexpectedly';
  return lastWords === '' ? text : `${text} (${lastWords})`;
}

type StartMessage = Extract<ToWorker, { kind: 'start' }>;

async function runSearch(
  module: SolverModule,
  host: WorkerHost,
  { jobId, sketchJson, settings }: StartMessage,
  isCancelled: () => boolean,
): Promise<FromWorker> {
  const begun = host.now();
  const session = new module.SolverSession(sketchJson, settingsText(settings));
  try {
    textOf(session.opened());
    const clock = new PhaseClock(host.now() - begun);
    const reporter = new Reporter(jobId, session, host);
    let iterations = FIRST_SLICE_ITERATIONS;
    let progress = readProgress(session);
    for (let done = false; !done; ) {
      if (isCancelled()) {
        return { kind: 'cancelled', jobId };
      }
      const start = host.now();
      done = session.advance(iterations);
      const elapsed = host.now() - start;
      clock.add(progress.phase, elapsed);
      iterations = nextSlice(iterations, elapsed);
      progress = readProgress(session);
      reporter.report(progress);
      await host.pause();
    }
    return {
      kind: 'solved',
      jobId,
      modelJson: session.modelJson(),
      reportJson: session.reportJson(),
      layoutJson: session.layoutJson(),
      seconds: clock.seconds(),
    };
  } finally {
    session.delete();
  }
}

function settingsText(settings: SolveSettings): string {
  return JSON.stringify(settings);
}

/** Iterations that should take one slice, at most four times more or less than before. */
function nextSlice(iterations: number, elapsedMs: number): number {
  const factor = Math.min(4, Math.max(0.25, SLICE_MS / Math.max(elapsedMs, 0.01)));
  return Math.min(MAX_SLICE_ITERATIONS, Math.max(1, Math.round(iterations * factor)));
}

/** The text is our own module's: tests/contract checks its fields. */
function readProgress(session: SolverSession): SolveProgress {
  return JSON.parse(session.progressJson()) as SolveProgress;
}

/** Seconds inside the module, by phase. */
class PhaseClock {
  readonly #byPhase: Record<string, number> = {};
  #totalMs: number;

  constructor(preparationMs: number) {
    this.#totalMs = preparationMs;
  }

  add(phase: string, elapsedMs: number): void {
    this.#totalMs += elapsedMs;
    this.#byPhase[phase] = (this.#byPhase[phase] ?? 0) + elapsedMs / 1000;
  }

  seconds() {
    return { total: this.#totalMs / 1000, byPhase: this.#byPhase };
  }
}

/** Posts progress now and then, and the best model when it is new: both cost time. */
class Reporter {
  readonly #jobId: number;
  readonly #session: SolverSession;
  readonly #host: WorkerHost;
  #nextProgress = 0;
  #nextModel = 0;
  #shownImprovements = 0;

  constructor(jobId: number, session: SolverSession, host: WorkerHost) {
    this.#jobId = jobId;
    this.#session = session;
    this.#host = host;
  }

  report(progress: SolveProgress): void {
    const now = this.#host.now();
    if (now < this.#nextProgress) {
      return;
    }
    const modelJson = this.#newModel(progress, now);
    this.#host.post({ kind: 'progress', jobId: this.#jobId, progress, modelJson });
    this.#nextProgress = now + PROGRESS_EVERY_MS;
  }

  #newModel(progress: SolveProgress, now: number): string | null {
    if (progress.improvements <= this.#shownImprovements || now < this.#nextModel) {
      return null;
    }
    this.#shownImprovements = progress.improvements;
    const modelJson = this.#session.modelJson();
    // A large model takes longer to write: never more than a tenth of the time goes there.
    this.#nextModel = now + Math.max(MODEL_EVERY_MS, 10 * (this.#host.now() - now));
    return modelJson;
  }
}
