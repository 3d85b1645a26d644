import { good, type Outcome } from '../../base/outcome.ts';
import { Catalogue, type Part } from '../../model/catalogue.ts';
import sizesFile from '../../model/known-sizes.json';
import type { SketchDocument } from '../../model/sketch.ts';
import type { KnownSizes } from '../../share/ldraw-guests.ts';
import { looksLikeMpd, readMpd } from '../../share/read-mpd.ts';
import { looksLikeObj, readObj } from '../../share/read-obj.ts';
import { type LegalOffer, legalOffer } from '../../state/legal-offer.ts';
import { readSketch, writeSketch } from '../../state/read-sketch.ts';

/** What the text of an opened file holds. */
export type ParsedFile =
  | { readonly kind: 'model'; readonly json: string; readonly notes: readonly string[] }
  /**
   * What the page's own reader says; `json` is the text for the core, whose word counts. Null where it is
   * not worth asking. `notes`: what was taken otherwise than it stands in the file, one sentence each. `legal`: the
   * nearest sketch that can be built, where this one cannot.
   */
  | {
      readonly kind: 'sketch';
      readonly read: Outcome<SketchDocument>;
      readonly json: string;
      readonly notes: readonly string[];
      readonly legal: LegalOffer | null;
    };

const PEEK = 4096;
const sizes: KnownSizes = sizesFile;

/**
 * Reads the text of a file: a sketch (.json, .obj) or a model (.json, .mpd). Pure, and slow for what is made to be: it
 * runs in a worker (read-worker.ts).
 * @param parts all parts that there are.
 * @param fileName what the file is called; a model of another program is called so too.
 */
export function parseFile(
  content: string,
  parts: readonly Part[],
  fileName = '',
): Outcome<ParsedFile> {
  if (looksLikeModel(content)) {
    return good({ kind: 'model', json: content, notes: [] });
  }
  if (looksLikeMpd(content)) {
    const notes: string[] = [];
    const model = readMpd(content, new Catalogue(parts), {
      note: (sentence) => notes.push(sentence),
      sizes,
      name: fileName.replace(/\.\w{2,5}$/, '').trim(),
    });
    return model.ok ? good({ kind: 'model', json: model.value, notes }) : model;
  }
  if (looksLikeObj(content)) {
    const notes: string[] = [];
    const drawn = readObj(content, '', (note) => notes.push(note));
    return drawn.ok ? good(sketchOf(writeSketch(drawn.value), notes)) : drawn;
  }
  return good(sketchOf(content, []));
}

/** A model says what it is in its first bytes; everything else is taken for a sketch. */
function looksLikeModel(content: string): boolean {
  return content.slice(0, PEEK).includes('"liftarm-model"');
}

function sketchOf(json: string, notes: readonly string[]): ParsedFile {
  const read = readSketch(json);
  return { kind: 'sketch', read, json, notes, legal: read.ok ? null : legalOffer(json) };
}
