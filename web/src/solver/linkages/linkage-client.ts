import type { LinkageMessage, PathRequest } from './linkage-module.ts';

/** The part of a worker that is needed. */
export interface LinkagePort {
  postMessage(message: PathRequest): void;
  terminate(): void;
  onmessage: ((event: { readonly data: LinkageMessage }) => void) | null;
  onerror: ((event: { readonly message?: string }) => void) | null;
}

/** What is told of a path: of an earlier one nothing any more once the next is asked for. */
export interface LinkageWatch {
  /** The table is being made, from 0 to 1; only before the first answer. */
  readonly onProgress: (fraction: number) => void;
  readonly onFound: (text: string, seconds: number) => void;
  /** The path is refused, or the worker has failed: one sentence. */
  readonly onFailed: (message: string) => void;
}

export interface LinkageClient {
  ask(pathJson: string): void;
  dispose(): void;
}

function startWorker(): LinkagePort {
  return new Worker(new URL('./linkage-worker.ts', import.meta.url), {
    type: 'module',
    name: 'liftarm-linkages',
  }) as LinkagePort;
}

/** Finds linkages in a worker of its own, which begins with its table at once. */
export function createLinkageClient(
  watch: LinkageWatch,
  start: () => LinkagePort = startWorker,
): LinkageClient {
  const worker = start();
  let last = 0;
  worker.onerror = (event) => watch.onFailed(event.message ?? 'the worker could not be loaded');
  worker.onmessage = ({ data }) => {
    if (data.kind === 'progress') {
      watch.onProgress(data.fraction);
    } else if (data.kind === 'failed') {
      watch.onFailed(data.message);
    } else if (data.id === last) {
      if (data.kind === 'found') {
        watch.onFound(data.text, data.seconds);
      } else {
        watch.onFailed(data.message);
      }
    }
  };
  return {
    ask: (pathJson) => {
      last += 1;
      worker.postMessage({ id: last, pathJson });
    },
    dispose: () => {
      worker.onmessage = null;
      worker.onerror = null;
      worker.terminate();
    },
  };
}
