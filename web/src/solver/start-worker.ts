import type { SolverBinary } from './protocol.ts';
import { compiledSolver } from './solver-binary.ts';
import type { WorkerPort } from './worker-client.ts';

/** The page's worker, with the module that all of them share. */
export function startSolverWorker(): WorkerPort {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), {
    type: 'module',
    name: 'liftarm-solver',
  });
  void compiledSolver().then((module) => {
    worker.postMessage({ kind: 'binary', module } satisfies SolverBinary);
  });
  return worker as WorkerPort;
}
