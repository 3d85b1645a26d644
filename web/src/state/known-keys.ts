// Keys that a format does not have are refused, as by the core (core/sketch/json_fields.cpp): most are
// misspelt, and what they say would be lost in silence.

const MOST_APART = 2;

/** What is wrong with the first key that is not known, or null. */
export function unknownKey(
  value: Readonly<Record<string, unknown>>,
  known: readonly string[],
): string | null {
  const key = Object.keys(value).find((each) => !known.includes(each));
  if (key === undefined) {
    return null;
  }
  const nearest = nearestKey(key, known);
  const likely = nearest === null ? '' : `, most likely ${nearest}`;
  return `unknown key "${key.slice(0, 40)}"${likely}; known keys here: ${known.join(', ')}`;
}

function nearestKey(key: string, known: readonly string[]): string | null {
  const [nearest] = known
    .map((name) => ({ name, apart: lettersApart(key.toLowerCase(), name.toLowerCase()) }))
    .filter(({ apart }) => apart <= MOST_APART)
    .sort((a, b) => a.apart - b.apart);
  return nearest?.name ?? null;
}

/** In how many letters two words differ at the least. */
function lettersApart(a: string, b: string): number {
  if (Math.abs(a.length - b.length) > MOST_APART) {
    return MOST_APART + 1;
  }
  let row = Array.from({ length: b.length + 1 }, (_, k) => k);
  for (const [i, letter] of [...a].entries()) {
    const next = [i + 1];
    for (const [k, other] of [...b].entries()) {
      const kept = (row[k] ?? 0) + (letter === other ? 0 : 1);
      next.push(Math.min(kept, (next[k] ?? 0) + 1, (row[k + 1] ?? 0) + 1));
    }
    row = next;
  }
  return row.at(-1) ?? 0;
}
