import type { Certificate } from './proof/certificate.ts';
import type { FromProver, ToProver } from './proof/messages.ts';
import type { ProofProgress } from './proof/prove.ts';

/** The part of a worker that a proof needs. */
export interface ProverPort {
  postMessage(message: ToProver): void;
  terminate(): void;
  onmessage: ((event: { readonly data: FromProver }) => void) | null;
  onerror: ((event: { readonly message?: string }) => void) | null;
}

export interface ProofWatch {
  readonly signal?: AbortSignal;
  readonly onProgress?: (progress: ProofProgress) => void;
}

function startProver(): ProverPort {
  return new Worker(new URL('./prover.ts', import.meta.url), {
    type: 'module',
    name: 'liftarm-prover',
  }) as ProverPort;
}

/**
 * Proves in a worker of its own how few beams do (proof/prove.ts). HiGHS cannot be asked to stop while it
 * works, so a proof that is cancelled ends with its worker.
 * @returns null when it was cancelled. Rejects when the proof cannot be found.
 */
export function proveInWorker(
  placementsJson: string,
  { signal, onProgress }: ProofWatch = {},
  start: () => ProverPort = startProver,
): Promise<Certificate | null> {
  if (signal?.aborted) {
    return Promise.resolve(null);
  }
  return new Promise((resolve, reject) => {
    const worker = start();
    const end = (settle: () => void) => {
      signal?.removeEventListener('abort', cancel);
      worker.onmessage = null;
      worker.onerror = null;
      worker.terminate();
      settle();
    };
    const cancel = () => end(() => resolve(null));
    signal?.addEventListener('abort', cancel);
    worker.onerror = (event) =>
      end(() => reject(new Error(event.message ?? 'the prover could not be loaded')));
    worker.onmessage = ({ data }) => {
      if (data.kind === 'progress') {
        onProgress?.(data.progress);
      } else if (data.kind === 'proved') {
        end(() => resolve(data.certificate));
      } else {
        end(() => reject(new Error(data.message)));
      }
    };
    worker.postMessage({ placementsJson });
  });
}
