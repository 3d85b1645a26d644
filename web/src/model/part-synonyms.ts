/**
 * Other numbers of parts that do the same: other moulds and numbers under which they are sold. From titles of the LDraw
 * library (61332, 4459 and 42924 are pins with friction of two and three modules) and from alternate item numbers that
 * catalogues of collectors give.
 */
const SAME: Readonly<Record<string, string>> = {
  64289: '40490',
  64290: '32525',
  64871: '32278',
  4459: '2780',
  61332: '2780',
  42924: '6558',
  6590: '3713',
  32123: '32123b',
  3648: '3648b',
};

/** A mould's letter, or a print: `3713a`, `32316pr0001`. */
const VARIANT = /^(\d+)(?:[a-f]|(?:pr|pb|pat|ps)\d+[a-z]?)+$/;

/** A number without what files write around it: `.dat`, and the folder before it. */
export function plainNumber(number: string): string {
  return number
    .trim()
    .toLowerCase()
    .replace(/^.*[\\/]/, '')
    .replace(/\.(dat|ldr)$/, '');
}

/** The number without the letter of a mould or the mark of a print. */
export function baseNumber(plain: string): string {
  return VARIANT.exec(plain)?.[1] ?? plain;
}

/**
 * The number under which a part is known here.
 * @param number as a list or a file gives it, with or without `.dat` and the folder before it.
 * @returns null where it is not known.
 */
export function knownNumber(number: string, known: ReadonlySet<string>): string | null {
  const plain = plainNumber(number);
  const base = baseNumber(plain);
  return [plain, SAME[plain], base, SAME[base]].find((id) => id && known.has(id)) ?? null;
}
