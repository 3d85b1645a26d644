/**
 * What the WebAssembly module offers: the hand-written twin of wasm/bindings.cpp (this Emscripten makes
 * no declarations). tests/contract/ compares the two.
 */

/** The names of base::Status in C++, in its order. */
export const SOLVER_STATUSES = [
  'ok',
  'invalidInput',
  'unsupported',
  'infeasible',
  'singular',
  'cancelled',
] as const;

export type SolverStatus = (typeof SOLVER_STATUSES)[number];

/** A text with status 'ok', or the message that says why there is none. */
export interface SolverReply {
  readonly status: SolverStatus;
  readonly text: string;
}

/** A stepped search. Lives in the module's memory until `delete()`. */
export interface SolverSession {
  /** Status 'ok', or why the input is refused; then only `delete()` may be called. */
  opened(): SolverReply;
  /** Does at most so many steps; true when the search has ended. */
  advance(iterations: number): boolean;
  progressJson(): string;
  modelJson(): string;
  /** The best layout, for `SolveSettings.earlier` of a search on a changed sketch. */
  layoutJson(): string;
  reportJson(): string;
  delete(): void;
}

export interface SolverModule {
  readonly SolverSession: new (sketchJson: string, settingsJson: string) => SolverSession;
  checkModelJson(modelJson: string): SolverReply;
  /** The building sequence; its keys are those of planAssemblyJson in core/design/design_session.h. */
  planAssemblyJson(modelJson: string): SolverReply;
  /** Stress under weight and loads; options and answer as in core/design/design_session.h. */
  analyseStressJson(modelJson: string, optionsJson: string): SolverReply;
  /** How a model stands and moves; keys as in core/design/design_session.h. */
  analyseMotionJson(modelJson: string): SolverReply;
  /** An annotated joint turned through its range. */
  jointMotionJson(modelJson: string, joint: number): SolverReply;
  /** One of the motions of analyseMotionJson, as far as it goes. */
  freeMotionJson(modelJson: string, motion: number): SolverReply;
  /** Symmetries that a sketch has but does not name, in the sketch's own format. */
  findSymmetriesJson(sketchJson: string): SolverReply;
  /** All that may be laid for a sketch, for proofs; keys as in core/design/placements.h. */
  placementsJson(sketchJson: string, settingsJson: string): SolverReply;
  /** Where the parts of a model lie on the lines of its sketch (core/design/part_places.h). */
  partPlacesJson(modelJson: string, layoutJson: string, settingsJson: string): SolverReply;
  /** What else could lie where a part of a model does. */
  fittingPartsJson(
    modelJson: string,
    layoutJson: string,
    settingsJson: string,
    part: number,
  ): SolverReply;
  exportModel(modelJson: string, format: string): SolverReply;
  contractJson(): string;
}

/** What the loader of the module (build/wasm/liftarm-core.js) takes. */
export interface SolverModuleOptions {
  readonly wasmBinary?: Uint8Array;
  readonly locateFile?: (name: string) => string;
  /** Instantiates the module in place of the loader, which would fetch it. */
  readonly instantiateWasm?: (
    imports: WebAssembly.Imports,
    done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
  ) => object;
  /** A line that the module writes to stderr: the place of a failed check. */
  readonly printErr?: (line: string) => void;
}

export type CreateSolverModule = (options: SolverModuleOptions) => Promise<SolverModule>;
