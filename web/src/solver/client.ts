import { startSolverWorker } from './start-worker.ts';
import {
  createWorkerClient,
  type SolverClient,
  type WorkerClientOptions,
} from './worker-client.ts';

/** A client with a worker of the page's own. */
export function createSolverClient(options: Partial<WorkerClientOptions> = {}): SolverClient {
  return createWorkerClient({ startWorker: startSolverWorker, ...options });
}
