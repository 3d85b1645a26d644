import { assertNever } from '../base/assert-never.ts';
import type {
  ExportFormat,
  FromWorker,
  Question,
  SolveProgress,
  SolveSeconds,
  SolveSettings,
  ToWorker,
} from './protocol.ts';

/** How a solve ended. Crashes are not in it: those reject with a SolverError. */
export type SolveResult =
  | {
      readonly outcome: 'solved';
      readonly modelJson: string;
      readonly reportJson: string;
      /** For `SolveSettings.earlier`. */
      readonly layoutJson: string;
      readonly seconds: SolveSeconds;
    }
  /** `modelJson` is the last model that progress has shown, null when there was none. */
  | { readonly outcome: 'cancelled'; readonly modelJson: string | null }
  | { readonly outcome: 'refused'; readonly message: string };

/** Asked and answered, or refused with the one sentence that says what is wrong. */
export type TextResult =
  | { readonly outcome: 'ok'; readonly text: string }
  | { readonly outcome: 'refused'; readonly message: string };

export interface SolveWatch {
  /** `modelJson` is null when the best model did not change since the last call. */
  readonly onProgress?: (progress: SolveProgress, modelJson: string | null) => void;
  /** Aborting settles the solve as `cancelled` at once. */
  readonly signal?: AbortSignal;
}

/**
 * The solver as the page's main thread sees it. Every promise settles exactly once. A worker that dies takes no job
 * along that it was not made to die by: what was open is asked again of a new one, once. A job whose signal is aborted
 * settles at once: a solve as `cancelled`, everything else by a rejection with the signal's reason; the worker
 * is free again within 100 milliseconds, replaced if it does not answer.
 */
export interface SolverClient {
  /** \param sketchJson text of a sketch file. Rejects with SolverError only when workers crashed over it. */
  solve(sketchJson: string, settings: SolveSettings, watch?: SolveWatch): Promise<SolveResult>;
  /** Every check on a model file; `text` is the check report as JSON. */
  check(modelJson: string, signal?: AbortSignal): Promise<TextResult>;
  exportModel(modelJson: string, format: ExportFormat, signal?: AbortSignal): Promise<TextResult>;
  /** A further question about a model file; `text` is the answer as JSON. */
  ask(question: Question, signal?: AbortSignal): Promise<TextResult>;
  /** Loads the module before it is needed. */
  warmUp(): void;
  /** Stops the worker; what was open settles: solves as `cancelled`, the rest with a SolverError. */
  dispose(): void;
}

/** The worker died or could not be loaded: a bug or no memory, never bad input. */
export class SolverError extends Error {
  override readonly name = 'SolverError';
}

/** What the client needs of a Worker, so that tests can put another thing in its place. */
export interface WorkerPort {
  postMessage(message: ToWorker): void;
  terminate(): void;
  onmessage: ((event: { readonly data: FromWorker }) => void) | null;
  onerror: ((event: { readonly message?: string }) => void) | null;
  onmessageerror: (() => void) | null;
}

export interface WorkerClientOptions {
  /** After a cancel the worker has this long to answer, in milliseconds; then it is terminated. */
  readonly cancelPatienceMs?: number;
  readonly startWorker: () => WorkerPort;
}

const CANCEL_PATIENCE_MS = 80;

/** One open job: what was asked, so that it can be asked again of a new worker, and how it settles. */
interface Job {
  readonly request: Exclude<ToWorker, { kind: 'cancel' }>;
  readonly onReply: (reply: FromWorker) => void;
  readonly onCrash: (error: SolverError) => void;
  readonly onDispose: () => void;
  /** Whether a worker has died before it answered, and another was asked. */
  askedAgain: boolean;
}

/** A client of whatever worker it is given: the page's, the package's in a browser, or a thread of Node. */
export function createWorkerClient(options: WorkerClientOptions): SolverClient {
  return new WorkerClient({ cancelPatienceMs: CANCEL_PATIENCE_MS, ...options });
}

class WorkerClient implements SolverClient {
  readonly #options: Required<WorkerClientOptions>;
  readonly #jobs = new Map<number, Job>();
  /** Cancelled jobs that the worker has not confirmed, with the timer that ends its patience. */
  readonly #stopping = new Map<number, ReturnType<typeof setTimeout>>();
  #worker: WorkerPort | null = null;
  #lastJobId = 0;

  constructor(options: Required<WorkerClientOptions>) {
    this.#options = options;
  }

  solve(sketchJson: string, settings: SolveSettings, watch: SolveWatch = {}): Promise<SolveResult> {
    return new Promise((resolve, reject) => {
      const jobId = this.#nextJobId();
      const { signal, onProgress } = watch;
      let lastModel: string | null = null;
      const finish = (settle: () => void) => {
        signal?.removeEventListener('abort', cancel);
        this.#jobs.delete(jobId);
        settle();
      };
      const cancelled = () => finish(() => resolve({ outcome: 'cancelled', modelJson: lastModel }));
      const cancel = () => {
        cancelled();
        this.#stopJob(jobId);
      };
      if (signal?.aborted) {
        resolve({ outcome: 'cancelled', modelJson: null });
        return;
      }
      signal?.addEventListener('abort', cancel);
      this.#begin({
        request: { kind: 'start', jobId, sketchJson, settings },
        onReply: (reply) => {
          if (reply.kind === 'progress') {
            lastModel = reply.modelJson ?? lastModel;
            onProgress?.(reply.progress, reply.modelJson);
            return;
          }
          finish(() => settleSolve(reply, lastModel, { resolve, reject }));
        },
        onCrash: (error) => finish(() => reject(error)),
        onDispose: cancelled,
        askedAgain: false,
      });
    });
  }

  check(modelJson: string, signal?: AbortSignal): Promise<TextResult> {
    return this.#ask({ kind: 'check', jobId: this.#nextJobId(), modelJson }, signal);
  }

  exportModel(modelJson: string, format: ExportFormat, signal?: AbortSignal): Promise<TextResult> {
    return this.#ask({ kind: 'export', jobId: this.#nextJobId(), modelJson, format }, signal);
  }

  ask(question: Question, signal?: AbortSignal): Promise<TextResult> {
    return this.#ask({ kind: 'ask', jobId: this.#nextJobId(), question }, signal);
  }

  warmUp(): void {
    this.#ensureWorker();
  }

  dispose(): void {
    this.#discardWorker();
    for (const job of [...this.#jobs.values()]) {
      job.onDispose();
    }
  }

  #ask(
    request: Extract<ToWorker, { kind: 'check' | 'export' | 'ask' }>,
    signal?: AbortSignal,
  ): Promise<TextResult> {
    return new Promise((resolve, reject) => {
      const finish = (settle: () => void) => {
        signal?.removeEventListener('abort', cancel);
        this.#jobs.delete(request.jobId);
        settle();
      };
      const cancel = () => {
        finish(() => reject(signal?.reason));
        this.#stopJob(request.jobId);
      };
      if (signal?.aborted) {
        reject(signal.reason);
        return;
      }
      signal?.addEventListener('abort', cancel);
      this.#begin({
        request,
        onReply: (reply) => finish(() => settleText(reply, { resolve, reject })),
        onCrash: (error) => finish(() => reject(error)),
        onDispose: () => finish(() => reject(new SolverError('the solver was closed'))),
        askedAgain: false,
      });
    });
  }

  #nextJobId(): number {
    this.#lastJobId += 1;
    return this.#lastJobId;
  }

  #begin(job: Job): void {
    this.#jobs.set(job.request.jobId, job);
    this.#ensureWorker().postMessage(job.request);
  }

  /** Asks the worker to drop a job that is settled here already, and replaces it when it is stuck. */
  #stopJob(jobId: number): void {
    this.#worker?.postMessage({ kind: 'cancel', jobId });
    this.#stopping.set(
      jobId,
      setTimeout(() => this.#replaceWorker(), this.#options.cancelPatienceMs),
    );
  }

  #replaceWorker(): void {
    this.#discardWorker();
    this.#askAgain([...this.#jobs.values()]);
  }

  #askAgain(jobs: readonly Job[]): void {
    for (const job of jobs) {
      this.#ensureWorker().postMessage(job.request);
    }
  }

  #ensureWorker(): WorkerPort {
    if (this.#worker !== null) {
      return this.#worker;
    }
    const worker = this.#options.startWorker();
    worker.onmessage = (event) => this.#receive(event.data);
    worker.onerror = (event) => this.#crash(event.message ?? 'the solver could not be loaded');
    worker.onmessageerror = () => this.#crash('the solver sent something unreadable');
    this.#worker = worker;
    return worker;
  }

  #receive(reply: FromWorker): void {
    if (reply.kind !== 'progress') {
      clearTimeout(this.#stopping.get(reply.jobId));
      this.#stopping.delete(reply.jobId);
    }
    if (reply.kind === 'failed') {
      this.#fail(reply.jobId, reply.message);
      return;
    }
    this.#jobs.get(reply.jobId)?.onReply(reply);
  }

  /** A job broke the worker, whose state is unknown: the others are asked of a new one. */
  #fail(jobId: number, message: string): void {
    const culprit = this.#jobs.get(jobId);
    this.#discardWorker();
    this.#askAgain([...this.#jobs.values()].filter((job) => job !== culprit));
    culprit?.onCrash(new SolverError(message));
  }

  /** The worker is gone, and nobody knows by which job: each is asked once more, and given up when that ends alike. */
  #crash(message: string): void {
    this.#discardWorker();
    const jobs = [...this.#jobs.values()];
    const lost = jobs.filter((job) => job.askedAgain);
    const left = jobs.filter((job) => !job.askedAgain);
    for (const job of left) {
      job.askedAgain = true;
    }
    this.#askAgain(left);
    for (const job of lost) {
      job.onCrash(new SolverError(message));
    }
  }

  #discardWorker(): void {
    for (const timer of this.#stopping.values()) {
      clearTimeout(timer);
    }
    this.#stopping.clear();
    if (this.#worker !== null) {
      this.#worker.onmessage = null;
      this.#worker.onerror = null;
      this.#worker.onmessageerror = null;
      this.#worker.terminate();
      this.#worker = null;
    }
  }
}

type Ending = Exclude<FromWorker, { kind: 'progress' }>;

interface Settle<T> {
  readonly resolve: (value: T) => void;
  readonly reject: (error: SolverError) => void;
}

function settleSolve(reply: Ending, lastModel: string | null, settle: Settle<SolveResult>): void {
  switch (reply.kind) {
    case 'solved':
      settle.resolve({
        outcome: 'solved',
        modelJson: reply.modelJson,
        reportJson: reply.reportJson,
        layoutJson: reply.layoutJson,
        seconds: reply.seconds,
      });
      return;
    case 'refused':
      settle.resolve({ outcome: 'refused', message: reply.message });
      return;
    case 'cancelled':
      settle.resolve({ outcome: 'cancelled', modelJson: lastModel });
      return;
    case 'checked':
    case 'exported':
    case 'answered':
    case 'failed':
      settle.reject(new SolverError(`a solve cannot end with '${reply.kind}'`));
      return;
    default:
      assertNever(reply);
  }
}

function settleText(reply: FromWorker, settle: Settle<TextResult>): void {
  switch (reply.kind) {
    case 'checked':
      settle.resolve({ outcome: 'ok', text: reply.checkJson });
      return;
    case 'exported':
    case 'answered':
      settle.resolve({ outcome: 'ok', text: reply.text });
      return;
    case 'refused':
      settle.resolve({ outcome: 'refused', message: reply.message });
      return;
    case 'progress':
    case 'solved':
    case 'cancelled':
    case 'failed':
      settle.reject(new SolverError(`a question cannot end with '${reply.kind}'`));
      return;
    default:
      assertNever(reply);
  }
}
