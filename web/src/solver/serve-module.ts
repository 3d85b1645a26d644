import { ownTurn } from './own-turn.ts';
import type { FromWorker, SolverBinary, ToWorker } from './protocol.ts';
import type { CreateSolverModule, SolverModule, SolverModuleOptions } from './solver-module.ts';
import { createWorkerCore } from './worker-core.ts';

/** Makes this worker answer with a module: the logic is worker-core.ts, which tests run without a worker. */
export function serveModule(create: CreateSolverModule, wasmUrl: string): void {
  let lastWords = '';
  let takeBinary: (module: WebAssembly.Module | null) => void = () => undefined;
  const loading = new Promise<WebAssembly.Module | null>((resolve) => {
    takeBinary = resolve;
  }).then(
    (compiled) =>
      new Promise<SolverModule>((resolve, reject) => {
        create({
          locateFile: () => wasmUrl,
          printErr: (line) => {
            lastWords = line;
          },
          ...(compiled ? instantiating(compiled, reject) : {}),
        }).then(resolve, reject);
      }),
  );
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
}

function instantiating(
  compiled: WebAssembly.Module,
  reject: (reason: unknown) => void,
): Pick<SolverModuleOptions, 'instantiateWasm'> {
  return {
    instantiateWasm: (imports, done) => {
      WebAssembly.instantiate(compiled, imports).then(
        (instance) => done(instance, compiled),
        reject,
      );
      return {};
    },
  };
}
