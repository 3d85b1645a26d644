// The package's door in Node.
import { Worker } from 'node:worker_threads';
import type { FromWorker } from '../solver/protocol.ts';
import { createWorkerClient, SolverError, type WorkerPort } from '../solver/worker-client.ts';
import { beside } from './beside.ts';
import { InputError, Liftarm } from './liftarm.ts';

/** Starts the engine in a thread; it is loaded when it is first asked, and ends with `close()`. */
export function createLiftarm(): Liftarm {
  return new Liftarm(createWorkerClient({ startWorker }));
}

function startWorker(): WorkerPort {
  const thread = new Worker(beside('node-worker.js'));
  const port: WorkerPort = {
    postMessage: (message) => thread.postMessage(message),
    terminate: () => void thread.terminate(),
    onmessage: null,
    onerror: null,
    onmessageerror: null,
  };
  thread.on('message', (data: FromWorker) => port.onmessage?.({ data }));
  thread.on('error', (error) => port.onerror?.({ message: String(error) }));
  thread.on('messageerror', () => port.onmessageerror?.());
  // A thread can end without an error, as when its process takes it down.
  thread.on('exit', (code) => port.onerror?.({ message: `the thread ended with ${code}` }));
  return port;
}

export { InputError, Liftarm, SolverError };
