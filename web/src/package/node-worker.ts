// The package's worker in Node. Glue alone.
import { readFile } from 'node:fs/promises';
import { parentPort } from 'node:worker_threads';
import type { ToWorker } from '../solver/protocol.ts';
import { beside } from './beside.ts';
import { createPackageCore } from './package-core.ts';

const core = createPackageCore({
  wasm: () => readFile(beside('liftarm-core.wasm')),
  post: (reply) => parentPort?.postMessage(reply),
  pause: () => new Promise((resolve) => setImmediate(resolve)),
});

parentPort?.on('message', (message: ToWorker) => void core.handle(message));
