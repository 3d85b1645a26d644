import { bad, good, type Outcome } from '../base/outcome.ts';
import type { Catalogue } from '../model/catalogue.ts';
import type { SketchDocument } from '../model/sketch.ts';
import { looksLikeMpd, readMpd } from '../share/read-mpd.ts';
import { looksLikeObj, readObj } from '../share/read-obj.ts';
import { type SolverClient, SolverError } from '../solver/client.ts';
import { MAX_SKETCH_BYTES, readSketch, writeSketch } from '../state/read-sketch.ts';
import { text } from '../ui/text.ts';

export const MAX_FILE_BYTES = 32 * 2 ** 20;
const PEEK = 4096;

/** What an opened file turned out to be. */
export type OpenedFile =
  | { readonly kind: 'sketch'; readonly sketch: SketchDocument }
  | { readonly kind: 'model'; readonly json: string };

/** Reads a file that a person chose: a sketch (.json, .obj) or a model (.json, .mpd). On failure one sentence. */
export async function readOpenedFile(
  file: Pick<File, 'size' | 'text'>,
  client: SolverClient,
  catalogue: Catalogue,
): Promise<Outcome<OpenedFile>> {
  if (file.size > MAX_FILE_BYTES) {
    return bad(text.files.tooLarge);
  }
  let content: string;
  try {
    content = await file.text();
  } catch {
    return bad(text.files.unreadable);
  }
  if (content.trim() === '') {
    return bad(text.files.empty);
  }
  if (looksLikeModel(content)) {
    return good({ kind: 'model', json: content });
  }
  if (looksLikeMpd(content)) {
    const model = readMpd(content, catalogue);
    return model.ok ? good({ kind: 'model', json: model.value }) : model;
  }
  const sketch = await checkedSketch(content, client);
  return sketch.ok ? good({ kind: 'sketch', sketch: sketch.value }) : sketch;
}

/** A model says what it is in its first bytes; everything else is taken for a sketch. */
function looksLikeModel(content: string): boolean {
  return content.slice(0, PEEK).includes('"liftarm-model"');
}

/** Reads a sketch; when it is refused the words are those of the core, which knows best. */
async function checkedSketch(
  content: string,
  client: SolverClient,
): Promise<Outcome<SketchDocument>> {
  if (looksLikeObj(content)) {
    const drawn = readObj(content, '');
    return drawn.ok ? checkedSketch(writeSketch(drawn.value), client) : drawn;
  }
  const read = readSketch(content);
  if (content.length > MAX_SKETCH_BYTES) {
    return read;
  }
  const refusal = await askCore(content, client);
  return refusal === null ? read : bad(refusal);
}

/** What the core's reader says against a sketch, or null. Ends the search as soon as it has begun. */
async function askCore(content: string, client: SolverClient): Promise<string | null> {
  const stop = new AbortController();
  try {
    const result = await client.solve(
      content,
      {},
      { signal: stop.signal, onProgress: () => stop.abort() },
    );
    return result.outcome === 'refused' ? result.message : null;
  } catch (error) {
    if (error instanceof SolverError) {
      return null;
    }
    throw error;
  }
}
