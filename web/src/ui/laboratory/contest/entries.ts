// What pupils hand in: a line each with a name, a link, and perhaps the score that they say it has.

export interface Entry {
  readonly name: string;
  /** The fragment of the link, without `#`; null where the line holds none. */
  readonly fragment: string | null;
  /** What the pupil says; null where they say nothing. */
  readonly claimed: number | null;
}

export const MAX_ENTRIES = 200;

const FRAGMENT = /#(s\d+\.[\w.-]+)/;
const LINK = /[^\s;,|"']*#s\d+\.[\w.-]+/;

/** The entries of a text: one a line, in any order of name, link and number; empty lines are none. */
export function readEntries(text: string): Entry[] {
  return text
    .split(/\r\n|\n|\r/)
    .filter((line) => line.trim() !== '')
    .slice(0, MAX_ENTRIES)
    .map(entryOf);
}

function entryOf(line: string, index: number): Entry {
  const fragment = FRAGMENT.exec(line)?.[1] ?? null;
  const [before = '', after = ''] = fragment === null ? [line] : line.split(LINK);
  const claimed = /-?\d+(?:[.,]\d+)?/.exec(after)?.[0] ?? null;
  const name = before.replace(/^[\s"'|;,:\t-]+|[\s"'|;,:\t-]+$/g, '').slice(0, 80);
  return {
    name: name === '' ? `${index + 1}` : name,
    fragment,
    claimed: claimed === null ? null : Number(claimed.replace(',', '.')),
  };
}
