import type { Catalogue } from '../model/catalogue.ts';
import { knownNumber } from '../model/part-synonyms.ts';
import type { LdrawFile } from './ldraw-rows.ts';

/** Of submodels in each other. */
export const MAX_DEPTH = 60;

/**
 * Which files of a document are submodels, to be followed, and which are parts. Some programs write the shapes of parts
 * into the document too: such a file is a part where its name ends with `.dat` or it draws something itself, and no part
 * that is known stands in it. core/importers/ldraw.cpp tells them apart alike.
 */
export class LdrawLeaves {
  readonly files: ReadonlyMap<string, LdrawFile>;
  readonly #numbers: ReadonlySet<string>;
  readonly #holds = new Map<string, boolean>();

  constructor(files: ReadonlyMap<string, LdrawFile>, catalogue: Catalogue) {
    this.files = files;
    this.#numbers = new Set(catalogue.parts.map(({ id }) => id));
  }

  /** The number under which a part is known here, or null. */
  known(file: string): string | null {
    return knownNumber(file, this.#numbers);
  }

  isSubmodel(file: string): boolean {
    const found = this.files.get(file);
    if (!found) {
      return false;
    }
    const part = file.endsWith('.dat');
    if (part && this.known(file) !== null) {
      return false;
    }
    return !(part || found.drawn.length > 0) || this.#holdsKnown(file);
  }

  /** Whether a known part stands in a file or in what it holds. A circle holds what else is in it. */
  #holdsKnown(file: string, depth = 0): boolean {
    if (depth > MAX_DEPTH) {
      // It is followed, and refused.
      return true;
    }
    const told = this.#holds.get(file);
    if (told !== undefined) {
      return told;
    }
    this.#holds.set(file, false);
    const rows = this.files.get(file)?.rows ?? [];
    const holds = rows.some((row) => {
      const leaf = !this.files.has(row.file) || row.file.endsWith('.dat');
      return (leaf && this.known(row.file) !== null) || this.#holdsKnown(row.file, depth + 1);
    });
    this.#holds.set(file, holds);
    return holds;
  }
}
