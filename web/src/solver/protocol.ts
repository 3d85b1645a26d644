/**
 * Messages between the page and the solver worker. Each carries the job it belongs to; a job begins with
 * one message of `ToWorker` and ends with exactly one message that `endsJob` accepts. Sketches, models
 * and reports travel as the JSON text that the module reads and writes: the file that a person downloads
 * is the text that was computed.
 */

/** Search settings; everything left out takes the module's own default (contract.ts). */
export interface SolveSettings {
  readonly seed?: number;
  readonly preset?: string;
  readonly method?: string;
  /** Single options by key, as `liftarm solve --set key=value`. */
  readonly set?: Readonly<Record<string, number | string | boolean>>;
  /**
   * The layout of a sketch that this one came from (`layoutJson` of an earlier reply, parsed): what is not
   * touched stays as it lies.
   */
  readonly earlier?: unknown;
}

/** Where a search stands. `fraction` runs from 0 to 1; counts are of the best layout so far. */
export interface SolveProgress {
  readonly done: boolean;
  readonly phase: string;
  readonly iterations: number;
  readonly fraction: number;
  readonly objective: number;
  readonly temperature: number;
  readonly beams: number;
  readonly gaps: number;
  readonly collisions: number;
  readonly failedConnections: number;
  /** How often the best layout changed; when it grew there is a new model. */
  readonly improvements: number;
  /** What each term of the objective adds for the best layout, by the core's names. */
  readonly terms: Readonly<Record<string, number>>;
}

/** Seconds spent inside the module: in all, and by the phase that `SolveProgress` names. */
export interface SolveSeconds {
  readonly total: number;
  readonly byPhase: Readonly<Record<string, number>>;
}

export type ExportFormat =
  | 'mpd'
  | 'parts.csv'
  | 'wanted.xml'
  | 'spreadsheet.csv'
  /** The building sequence (instructions/assembly-plan.ts). */
  | 'assembly.json'
  /** The frame for CalculiX and for ANSYS. */
  | 'inp'
  | 'apdl';

/** What can be asked of a model file; answers are JSON texts, see core/design/design_session.h. */
export interface StressQuestion {
  readonly about: 'stress';
  readonly modelJson: string;
  readonly optionsJson: string;
}

/** How a model stands and moves. */
export interface MotionQuestion {
  readonly about: 'motion';
  readonly modelJson: string;
}

/** Key poses of an annotated joint, or of one of the motions of the answer about motion. */
export interface PathQuestion {
  readonly about: 'path';
  readonly modelJson: string;
  readonly of: 'joint' | 'motion';
  readonly index: number;
}

/** Symmetries that a sketch has but does not name, for a person to confirm (core/design/symmetries.h). */
export interface SymmetriesQuestion {
  readonly about: 'symmetries';
  readonly sketchJson: string;
}

/** All that may be laid for a sketch, for a proof of how few beams do (solver/proof/placements.ts). */
export interface PlacementsQuestion {
  readonly about: 'placements';
  readonly sketchJson: string;
  readonly settings: SolveSettings;
}

/** Whether a search for a sketch can begin: an empty answer, or the refusal that says why not. */
export interface OpensQuestion {
  readonly about: 'opens';
  readonly sketchJson: string;
  readonly settings: SolveSettings;
}

/** Where the parts of a model lie on the lines of its sketch, as `keep` has them. */
export interface PlacesQuestion {
  readonly about: 'places';
  readonly modelJson: string;
  readonly layoutJson: string;
  readonly settings: SolveSettings;
}

/** What else could lie where a part of a model does. */
export interface FitsQuestion extends Omit<PlacesQuestion, 'about'> {
  readonly about: 'fits';
  /** By its index in the model. */
  readonly part: number;
}

export type Question =
  | PlacesQuestion
  | FitsQuestion
  | StressQuestion
  | MotionQuestion
  | PathQuestion
  | SymmetriesQuestion
  | OpensQuestion
  | PlacementsQuestion;

export type ToWorker =
  /** Replies: any number of `progress`, then `solved`, `refused`, `cancelled` or `failed`. */
  | {
      readonly kind: 'start';
      readonly jobId: number;
      readonly sketchJson: string;
      readonly settings: SolveSettings;
    }
  /** Ends the solve of that number with `cancelled`; no reply when it has ended already, or is no solve. */
  | { readonly kind: 'cancel'; readonly jobId: number }
  /** Replies: `checked`, `refused` or `failed`. */
  | { readonly kind: 'check'; readonly jobId: number; readonly modelJson: string }
  /** Replies: `exported`, `refused` or `failed`. */
  | {
      readonly kind: 'export';
      readonly jobId: number;
      readonly modelJson: string;
      readonly format: ExportFormat;
    }
  /** Replies: `answered`, `refused` or `failed`. */
  | { readonly kind: 'ask'; readonly jobId: number; readonly question: Question };

export type FromWorker =
  /** `modelJson` is null when the best model is the one of an earlier message. */
  | {
      readonly kind: 'progress';
      readonly jobId: number;
      readonly progress: SolveProgress;
      readonly modelJson: string | null;
    }
  /** The search ended; whether the model is buildable stands in the report. */
  | {
      readonly kind: 'solved';
      readonly jobId: number;
      readonly modelJson: string;
      readonly reportJson: string;
      readonly layoutJson: string;
      readonly seconds: SolveSeconds;
    }
  /** The input is not acceptable: one sentence that names the place and what would be right. */
  | { readonly kind: 'refused'; readonly jobId: number; readonly message: string }
  | { readonly kind: 'cancelled'; readonly jobId: number }
  | { readonly kind: 'checked'; readonly jobId: number; readonly checkJson: string }
  | { readonly kind: 'exported'; readonly jobId: number; readonly text: string }
  | { readonly kind: 'answered'; readonly jobId: number; readonly text: string }
  /** A bug or no memory. The module's state is unknown: discard the worker. */
  | { readonly kind: 'failed'; readonly jobId: number; readonly message: string };

/** Whether a reply is the last one of its job. */
export function endsJob(reply: FromWorker): boolean {
  return reply.kind !== 'progress';
}

/** What each worker waits for before its first job: the compiled module, or null to load it by itself. */
export interface SolverBinary {
  readonly kind: 'binary';
  readonly module: WebAssembly.Module | null;
}
