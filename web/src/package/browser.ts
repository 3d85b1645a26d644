// The package's door in a browser: no bundler is needed, the four files lie side by side.
import { createWorkerClient, SolverError, type WorkerPort } from '../solver/worker-client.ts';
import { beside } from './beside.ts';
import { InputError, Liftarm } from './liftarm.ts';

/** Starts the engine in a web worker; it is loaded when it is first asked. */
export function createLiftarm(): Liftarm {
  const address = beside('worker.js');
  return new Liftarm(
    createWorkerClient({
      startWorker: () => new Worker(address, { type: 'module' }) as WorkerPort,
    }),
  );
}

export { InputError, Liftarm, SolverError };
