import wasmUrl from '@wasm/liftarm-core.wasm?url';

let compiling: Promise<WebAssembly.Module | null> | null = null;

/**
 * The module, fetched and compiled once for all workers. Null where that is not possible, as on servers that
 * do not call it application/wasm: then each worker loads it.
 */
export function compiledSolver(): Promise<WebAssembly.Module | null> {
  compiling ??= WebAssembly.compileStreaming(fetch(wasmUrl)).catch(() => null);
  return compiling;
}
