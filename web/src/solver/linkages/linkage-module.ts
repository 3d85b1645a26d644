/** The hand-written twin of wasm/linkages/bindings.cpp: a module of its own, loaded when a path is drawn. */

/** A text, or with `ok` false the sentence that says what is wrong. */
export interface LinkageReply {
  readonly ok: boolean;
  readonly text: string;
}

/** The table of coupler curves. Lives in the module's memory until `delete()`. */
export interface LinkageTable {
  /** Adds the curves of so many couplers; true when all are in. */
  advance(couplers: number): boolean;
  fraction(): number;
  /** Path and answer as in core/linkages/linkage_json.h. */
  find(pathJson: string): LinkageReply;
  delete(): void;
}

export interface LinkageModule {
  readonly LinkageTable: new () => LinkageTable;
}

export type CreateLinkageModule = (options: {
  readonly wasmBinary?: Uint8Array;
  readonly locateFile?: (name: string) => string;
}) => Promise<LinkageModule>;

/** To the worker: a path, numbered so that late answers are known. */
export interface PathRequest {
  readonly id: number;
  readonly pathJson: string;
}

/** From the worker. */
export type LinkageMessage =
  | { readonly kind: 'progress'; readonly fraction: number }
  | { readonly kind: 'found'; readonly id: number; readonly text: string; readonly seconds: number }
  | { readonly kind: 'refused'; readonly id: number; readonly message: string }
  | { readonly kind: 'failed'; readonly message: string };
