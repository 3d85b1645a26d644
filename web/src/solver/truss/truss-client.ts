import type { BridgeContest } from '../../model/contest/bridge.ts';
import type { GhostTruss } from './ghost-truss.ts';

export type FromTruss =
  | { readonly ok: true; readonly truss: GhostTruss }
  | { readonly ok: false; readonly message: string };

/** The part of a worker that a truss needs. */
export interface TrussPort {
  postMessage(message: BridgeContest): void;
  terminate(): void;
  onmessage: ((event: { readonly data: FromTruss }) => void) | null;
  onerror: ((event: { readonly message?: string }) => void) | null;
}

function startTruss(): TrussPort {
  return new Worker(new URL('./truss-worker.ts', import.meta.url), {
    type: 'module',
    name: 'liftarm-truss',
  }) as TrussPort;
}

/**
 * The lightest truss, found in a worker of its own, which ends with it. HiGHS cannot be asked to stop while it works, so a
 * search that is cancelled ends with its worker.
 * @returns null when it was cancelled. Rejects when there is none.
 */
export function findTruss(
  contest: BridgeContest,
  signal: AbortSignal,
  start: () => TrussPort = startTruss,
): Promise<GhostTruss | null> {
  if (signal.aborted) {
    return Promise.resolve(null);
  }
  return new Promise((resolve, reject) => {
    const worker = start();
    const end = (settle: () => void) => {
      signal.removeEventListener('abort', cancel);
      worker.onmessage = null;
      worker.onerror = null;
      worker.terminate();
      settle();
    };
    const cancel = () => end(() => resolve(null));
    signal.addEventListener('abort', cancel);
    worker.onerror = (event) =>
      end(() => reject(new Error(event.message ?? 'the worker could not be loaded')));
    worker.onmessage = ({ data }) =>
      end(() => (data.ok ? resolve(data.truss) : reject(new Error(data.message))));
    worker.postMessage(contest);
  });
}
