import { bad, good, type Outcome } from '../base/outcome.ts';
import type { Catalogue } from '../model/catalogue.ts';
import type { SketchDocument } from '../model/sketch.ts';
import { decodeText } from '../share/decode-text.ts';
import { looksLikeArchive, modelInArchive } from '../share/studio-file.ts';
import { type SolverClient, SolverError } from '../solver/worker-client.ts';
import type { LegalOffer } from '../state/legal-offer.ts';
import { MAX_SKETCH_BYTES } from '../state/read-sketch.ts';
import { text } from '../ui/text.ts';
import type { FileReading } from './reading/file-reader.ts';

export const MAX_FILE_BYTES = 32 * 2 ** 20;

/** What an opened file turned out to be. */
export type OpenedFile =
  | {
      readonly kind: 'sketch';
      readonly sketch: SketchDocument;
      readonly notes: readonly string[];
    }
  | { readonly kind: 'model'; readonly json: string; readonly notes: readonly string[] }
  /** A sketch that is refused, and the nearest that would not be. */
  | {
      readonly kind: 'offer';
      readonly message: string;
      readonly legal: LegalOffer;
      readonly notes: readonly string[];
    };

/** What reading a file needs. */
export interface FileHelp {
  readonly client: SolverClient;
  readonly catalogue: Catalogue;
  readonly read: FileReading;
}

/**
 * Reads a file that a person chose: a sketch (.json, .obj) or a model (.json, .mpd, .ldr, .io). On failure one sentence. Rejects
 * with the signal's reason at once when it is aborted.
 */
export async function readOpenedFile(
  file: Pick<File, 'size' | 'arrayBuffer'> & { readonly name?: string },
  { client, catalogue, read }: FileHelp,
  signal: AbortSignal,
): Promise<Outcome<OpenedFile>> {
  if (file.size > MAX_FILE_BYTES) {
    return bad(text.files.tooLarge);
  }
  let content: string;
  try {
    const bytes = await modelBytes(new Uint8Array(await file.arrayBuffer()));
    if (!bytes.ok) {
      return bytes;
    }
    content = decodeText(bytes.value);
  } catch {
    return bad(text.files.unreadable);
  }
  if (content.trim() === '') {
    return bad(text.files.empty);
  }
  const parsed = await read({ content, name: file.name, parts: catalogue.parts }, signal);
  if (!parsed.ok || parsed.value.kind === 'model') {
    return parsed as Outcome<OpenedFile>;
  }
  const { read: own, json, notes, legal } = parsed.value;
  // When it is refused the words are those of the core, which knows best.
  const refusal = json.length > MAX_SKETCH_BYTES ? null : await askCore(json, client, signal);
  if (refusal === null && own.ok) {
    return good({ kind: 'sketch', sketch: own.value, notes });
  }
  const message = refusal ?? (own.ok ? '' : own.message);
  return legal ? good({ kind: 'offer', message, legal, notes }) : bad(message);
}

/** The bytes of a file, or those of the model in it where it is an archive. */
async function modelBytes(
  bytes: Uint8Array<ArrayBuffer>,
): Promise<Outcome<Uint8Array<ArrayBuffer>>> {
  return looksLikeArchive(bytes) ? modelInArchive(bytes) : good(bytes);
}

/** What the core's reader says against a sketch, or null. Ends the search as soon as it has begun. */
async function askCore(
  content: string,
  client: SolverClient,
  signal: AbortSignal,
): Promise<string | null> {
  const stop = new AbortController();
  signal.addEventListener('abort', () => stop.abort());
  try {
    const result = await client.solve(
      content,
      {},
      { signal: stop.signal, onProgress: () => stop.abort() },
    );
    signal.throwIfAborted();
    return result.outcome === 'refused' ? result.message : null;
  } catch (error) {
    if (error instanceof SolverError) {
      return null;
    }
    throw error;
  }
}
