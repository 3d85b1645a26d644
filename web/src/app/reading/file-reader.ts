import { bad, type Outcome } from '../../base/outcome.ts';
import type { Part } from '../../model/catalogue.ts';
import { text } from '../../ui/text.ts';
import type { ParsedFile } from './parse-file.ts';

export interface ReadRequest {
  readonly content: string;
  /** Of the file. */
  readonly name?: string | undefined;
  /** All that there are. */
  readonly parts: readonly Part[];
}

/** Reads the text of a file. Rejects with the signal's reason at once when it is aborted. */
export type FileReading = (
  request: ReadRequest,
  signal: AbortSignal,
) => Promise<Outcome<ParsedFile>>;

/** In a worker of its own, which ends with the answer or with the signal. */
export const readInWorker: FileReading = (request, signal) => {
  const worker = new Worker(new URL('./read-worker.ts', import.meta.url), {
    type: 'module',
    name: 'liftarm-reader',
  });
  return new Promise<Outcome<ParsedFile>>((resolve, reject) => {
    signal.throwIfAborted();
    signal.addEventListener('abort', () => reject(signal.reason));
    worker.onmessage = ({ data }: MessageEvent<Outcome<ParsedFile>>) => resolve(data);
    worker.onerror = () => resolve(bad(text.files.unreadable));
    worker.postMessage(request);
  }).finally(() => worker.terminate());
};
