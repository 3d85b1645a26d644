// Glue alone: the logic is worker-core.ts, which tests run without a worker.
import createLiftarmCore from '@wasm/liftarm-core.js';
import wasmUrl from '@wasm/liftarm-core.wasm?url';
import { ownTurn } from './own-turn.ts';
import type { FromWorker, SolverBinary, ToWorker } from './protocol.ts';
import type { SolverModule, SolverModuleOptions } from './solver-module.ts';
import { createWorkerCore } from './worker-core.ts';

let lastWords = '';

let takeBinary: (module: WebAssembly.Module | null) => void = () => undefined;
const loading = new Promise<WebAssembly.Module | null>((resolve) => {
  takeBinary = resolve;
}).then(load);

function load(compiled: WebAssembly.Module | null): Promise<SolverModule> {
  return new Promise((resolve, reject) => {
    const instantiate: Pick<SolverModuleOptions, 'instantiateWasm'> = compiled
      ? {
          instantiateWasm: (imports, done) => {
            WebAssembly.instantiate(compiled, imports).then(
              (instance) => done(instance, compiled),
              reject,
            );
            return {};
          },
        }
      : {};
    createLiftarmCore({
      locateFile: () => wasmUrl,
      printErr: (line) => {
        lastWords = line;
      },
      ...instantiate,
    }).then(resolve, reject);
  });
}

const core = createWorkerCore(loading, {
  post: (reply: FromWorker) => postMessage(reply),
  now: () => performance.now(),
  pause: ownTurn,
  lastWords: () => lastWords,
});

addEventListener('message', ({ data }: MessageEvent<ToWorker | SolverBinary>) => {
  if (data.kind === 'binary') {
    takeBinary(data.module);
  } else {
    void core.handle(data);
  }
});
