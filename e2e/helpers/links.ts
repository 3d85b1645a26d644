import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import type { SketchDocument } from '../../web/src/model/sketch.ts';
import { decodeShare, encodeShare } from '../../web/src/share/codec.ts';

/** A sketch of public/, by its path there without `.sketch.json`. */
export function publicSketch(path: string): SketchDocument {
  const file = resolve(import.meta.dirname, '../../public', `${path}.sketch.json`);
  return JSON.parse(readFileSync(file, 'utf8')) as SketchDocument;
}

/** The address fragment, with `#`, that opens a sketch. */
export async function linkOf(sketch: SketchDocument): Promise<string> {
  const fragment = await encodeShare({ sketch, preset: 'simple', seed: 1 });
  if (!fragment.ok) {
    throw new Error(fragment.message);
  }
  return `#${fragment.value}`;
}

/** The name of the sketch that an address holds; null while it holds none. */
export async function nameIn(address: string): Promise<string | null> {
  const read = await decodeShare(new URL(address).hash.slice(1));
  return read?.ok ? (read.value.sketch.name ?? '') : null;
}
