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

/** Finds linkages in a worker of its own, which begins with its table at once. One that fails is not asked again. */
export function createLinkageClient(
  watch: LinkageWatch,
  start: () => LinkagePort = startWorker,
): LinkageClient {
  let last = 0;
  let worker: LinkagePort | null = null;
  const drop = () => {
    if (worker) {
      worker.onmessage = null;
      worker.onerror = null;
      worker.terminate();
      worker = null;
    }
  };
  const fail = (message: string) => {
    drop();
    watch.onFailed(message);
  };
  const receive = (data: LinkageMessage) => {
    if (data.kind === 'progress') {
      watch.onProgress(data.fraction);
    } else if (data.kind === 'failed') {
      fail(data.message);
    } else if (data.id === last) {
      if (data.kind === 'found') {
        watch.onFound(data.text, data.seconds);
      } else {
        watch.onFailed(data.message);
      }
    }
  };
  const begin = () => {
    const begun = start();
    begun.onerror = (event) => fail(event.message ?? 'the worker could not be loaded');
    begun.onmessage = ({ data }) => receive(data);
    return begun;
  };
  worker = begin();
  return {
    ask: (pathJson) => {
      last += 1;
      worker ??= begin();
      worker.postMessage({ id: last, pathJson });
    },
    dispose: drop,
  };
}
