import wasmUrl from '@wasm/liftarm-lab.wasm?url';
import type { SolverBinary } from '../protocol.ts';
import { compileOnce } from '../solver-binary.ts';
import { createWorkerClient, type SolverClient, type WorkerPort } from '../worker-client.ts';

const compiledLab = compileOnce(wasmUrl);

function startLabWorker(): WorkerPort {
  const worker = new Worker(new URL('./lab-worker.ts', import.meta.url), {
    type: 'module',
    name: 'liftarm-lab',
  });
  void compiledLab().then((module) => {
    worker.postMessage({ kind: 'binary', module } satisfies SolverBinary);
  });
  return worker as WorkerPort;
}

/** A client with a worker of the laboratory: a module that has the rivals of the paper's comparison too. */
export function createLabClient(): SolverClient {
  return createWorkerClient({ startWorker: startLabWorker });
}
