import wasmUrl from '@wasm/liftarm-core.wasm?url';

/**
 * A module that is fetched and compiled once for all workers, when the first one asks. Null where that is not possible,
 * as on servers that do not call it application/wasm: then each worker loads it.
 */
export function compileOnce(url: string): () => Promise<WebAssembly.Module | null> {
  let compiling: Promise<WebAssembly.Module | null> | null = null;
  return () => {
    compiling ??= WebAssembly.compileStreaming(fetch(url)).catch(() => null);
    return compiling;
  };
}

export const compiledSolver = compileOnce(wasmUrl);
