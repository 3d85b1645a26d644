import createLiftarmCore from '@wasm/liftarm-core.js';
import type { FromWorker } from '../solver/protocol.ts';
import { createWorkerCore, type WorkerCore } from '../solver/worker-core.ts';

/** What Node and a browser do differently. */
export interface PackageHost {
  /** The bytes of the module. */
  wasm(): Promise<Uint8Array>;
  post(reply: FromWorker): void;
  /** Resolves after messages that wait have been taken. */
  pause(): Promise<void>;
}

/** The worker's logic with the module loaded from the package's own folder. */
export function createPackageCore(host: PackageHost): WorkerCore {
  let lastWords = '';
  const printErr = (line: string) => {
    lastWords = line;
  };
  const loading = host.wasm().then((wasmBinary) => createLiftarmCore({ wasmBinary, printErr }));
  return createWorkerCore(loading, {
    post: host.post,
    pause: host.pause,
    now: () => performance.now(),
    lastWords: () => lastWords,
  });
}
