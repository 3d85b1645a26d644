import type { AssemblyPlan } from '../instructions/assembly-plan.ts';
import type { Model } from '../model/model.ts';
import type { MotionAnswer } from '../model/motion.ts';
import type { CheckReport, Report } from '../model/report.ts';
import type { SketchDocument } from '../model/sketch.ts';
import type { StressOptions, StressRefusal, StressResult } from '../model/stress.ts';
import type { ExportFormat, SolveProgress, SolveSettings } from '../solver/protocol.ts';
import type { SolverClient, TextResult } from '../solver/worker-client.ts';

/** What a sketch or a model is given as: an object of its format, or the text of a file. */
export type FileOf<T> = T | string;

/** What a search is told beside the sketch; docs/schemas/settings.schema.json. */
export interface SolveOptions extends SolveSettings {
  /** Called some times a second; `model` is null while the best one is still that of an earlier call. */
  readonly onProgress?: (progress: SolveProgress, model: Model | null) => void;
  /** Ends the search: the promise rejects with the signal's reason within a tenth of a second. */
  readonly signal?: AbortSignal;
}

/** A search that has ended. Whether the model is buildable, and what is wrong otherwise, stands in the report. */
export interface Solution {
  readonly model: Model;
  readonly report: Report;
  /** For `SolveOptions.earlier` of a search on a changed sketch. */
  readonly layout: unknown;
}

/** A sketch, model or setting that is refused: one sentence that names the place and what would be right. */
export class InputError extends Error {
  override readonly name = 'InputError';
}

/**
 * The engine in a worker of its own: one job after another, none of them on the caller's thread. Every promise
 * rejects with `InputError` where the input is refused, and with `SolverError` where the worker could not go on.
 * Same sketch, settings and seed: same model, in Node and in every browser.
 */
export class Liftarm {
  readonly #client: SolverClient;

  constructor(client: SolverClient) {
    this.#client = client;
  }

  /** Finds a model that covers the sketch. */
  async solve(sketch: FileOf<SketchDocument>, options: SolveOptions = {}): Promise<Solution> {
    const { onProgress, signal, ...settings } = options;
    const result = await this.#client.solve(textOf(sketch), settings, {
      ...(signal && { signal }),
      ...(onProgress && {
        onProgress: (progress, model) => onProgress(progress, model === null ? null : read(model)),
      }),
    });
    switch (result.outcome) {
      case 'solved':
        return {
          model: read(result.modelJson),
          report: read(result.reportJson),
          layout: read(result.layoutJson),
        };
      case 'refused':
        throw new InputError(result.message);
      case 'cancelled':
        throw signal?.reason ?? new DOMException('the engine was closed', 'AbortError');
    }
  }

  /** Every check of a model, by code that shares the catalogue alone with the search. */
  async check(model: FileOf<Model>, signal?: AbortSignal): Promise<CheckReport> {
    return read(accepted(await this.#client.check(textOf(model), signal)));
  }

  /** The text of a file of that format: LDraw, parts lists, building sequence, frame. */
  async exportModel(
    model: FileOf<Model>,
    format: ExportFormat,
    signal?: AbortSignal,
  ): Promise<string> {
    return accepted(await this.#client.exportModel(textOf(model), format, signal));
  }

  /** In which order its parts go on, with subassemblies and their copies. */
  async planAssembly(model: FileOf<Model>, signal?: AbortSignal): Promise<AssemblyPlan> {
    return read(await this.exportModel(model, 'assembly.json', signal));
  }

  /** Stress under its weight and loads, by a linear frame of its beams; or what moves without resistance. */
  async analyseStress(
    model: FileOf<Model>,
    options: Partial<StressOptions> = {},
    signal?: AbortSignal,
  ): Promise<StressResult | StressRefusal> {
    return this.#ask(
      { about: 'stress', modelJson: textOf(model), optionsJson: JSON.stringify(options) },
      signal,
    );
  }

  /** Freedoms, ranges of the joints, balance and the braces that would stiffen it. */
  async analyseMotion(model: FileOf<Model>, signal?: AbortSignal): Promise<MotionAnswer> {
    return this.#ask({ about: 'motion', modelJson: textOf(model) }, signal);
  }

  /** Ends the worker; what is still open rejects. */
  close(): void {
    this.#client.dispose();
  }

  async #ask<T>(
    question: Parameters<SolverClient['ask']>[0],
    signal: AbortSignal | undefined,
  ): Promise<T> {
    return read(accepted(await this.#client.ask(question, signal)));
  }
}

function accepted(result: TextResult): string {
  if (result.outcome === 'refused') {
    throw new InputError(result.message);
  }
  return result.text;
}

function textOf(file: FileOf<object>): string {
  return typeof file === 'string' ? file : JSON.stringify(file);
}

/** The core's own text: tests/contract hold its keys against the types. */
function read<T>(json: string): T {
  return JSON.parse(json) as T;
}
