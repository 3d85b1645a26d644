/** Longer numbers are no sizes of anything that is drawn. */
const MAX_DIGITS = 3;

/** What parts sizes from one another: `6,8,4`, `6 x 8 x 4`. */
const BETWEEN = /[^\d]+/;

/**
 * What was typed, as so many sizes at most with commas between them. One comma at the end stays: the next size
 * follows it.
 */
export function tidySizes(typed: string, most: number): string {
  const numbers = typed.split(BETWEEN).map((one) => one.replace(/^0+/, '').slice(0, MAX_DIGITS));
  const begun = numbers.filter((one, i) => one !== '' || i === numbers.length - 1);
  const kept = begun.slice(0, most);
  return kept.length === 1 ? (kept[0] ?? '') : kept.join(',');
}

/** The sizes typed so far, in order. */
export function sizesOf(typed: string): number[] {
  return typed
    .split(',')
    .map(Number)
    .filter((size) => size >= 1);
}
