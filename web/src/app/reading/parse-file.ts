import { good, type Outcome } from '../../base/outcome.ts';
import type { SketchDocument } from '../../model/sketch.ts';
import { looksLikeMpd, readMpd } from '../../share/read-mpd.ts';
import { looksLikeObj, readObj } from '../../share/read-obj.ts';
import { readSketch, writeSketch } from '../../state/read-sketch.ts';

/** What the text of an opened file holds. */
export type ParsedFile =
  | { readonly kind: 'model'; readonly json: string }
  /**
   * What the page's own reader says; `json` is the text for the core, whose word counts. Null where it is
   * not worth asking.
   */
  | { readonly kind: 'sketch'; readonly read: Outcome<SketchDocument>; readonly json: string };

const PEEK = 4096;

/**
 * Reads the text of a file: a sketch (.json, .obj) or a model (.json, .mpd). Pure, and slow for what is made to be: it
 * runs in a worker (read-worker.ts).
 * @param parts numbers of all parts that there are.
 */
export function parseFile(content: string, parts: readonly string[]): Outcome<ParsedFile> {
  if (looksLikeModel(content)) {
    return good({ kind: 'model', json: content });
  }
  if (looksLikeMpd(content)) {
    const known = new Set(parts);
    const model = readMpd(content, {
      find: (part) => (known.has(part) ? part : undefined),
    });
    return model.ok ? good({ kind: 'model', json: model.value }) : model;
  }
  if (looksLikeObj(content)) {
    const drawn = readObj(content, '');
    return drawn.ok ? good(sketchOf(writeSketch(drawn.value))) : drawn;
  }
  return good(sketchOf(content));
}

/** A model says what it is in its first bytes; everything else is taken for a sketch. */
function looksLikeModel(content: string): boolean {
  return content.slice(0, PEEK).includes('"liftarm-model"');
}

function sketchOf(json: string): ParsedFile {
  return { kind: 'sketch', read: readSketch(json), json };
}
