import { bad, good, type Outcome } from '../base/outcome.ts';

/** More rows than this are no parts list. */
const MAX_ROWS = 20_000;
const MAX_COUNT = 100_000;
const PART_NAMES = [
  'part',
  'part_num',
  'partnum',
  'part number',
  'itemid',
  'design',
  'ldraw',
  'id',
];
const COUNT_NAMES = ['quantity', 'qty', 'count', 'minqty', 'number', 'pieces'];

/**
 * Reads a list of owned parts: our own parts.csv, the lists that collectors' sites export (comma,
 * semicolon or tab), or plain rows such as `32524 8`. Colours are added up.
 * @returns counts by part number, or one sentence that says what is wrong.
 */
export function readPartsList(text: string): Outcome<ReadonlyMap<string, number>> {
  const rows = text.split(/\r?\n/).filter((row) => row.trim() !== '');
  const [first] = rows;
  if (first === undefined) {
    return bad('the file is empty');
  }
  if (rows.length > MAX_ROWS) {
    return bad(`the list has more than ${MAX_ROWS} rows, which is the limit`);
  }
  const separator = [';', '\t', ','].find((each) => first.includes(each)) ?? /\s+/;
  const counts = countRows(rows.map((row) => row.split(separator).map(unquoted)));
  return counts.size > 0
    ? good(counts)
    : bad('no row has a part number and a count, such as "32524,8"');
}

function countRows(rows: readonly (readonly string[])[]): Map<string, number> {
  const head = (rows[0] ?? []).map((cell) => cell.toLowerCase());
  const part = head.findIndex((name) => PART_NAMES.includes(name));
  const count = head.findIndex((name) => COUNT_NAMES.includes(name));
  const named = part >= 0 && count >= 0;
  const counts = new Map<string, number>();
  for (const row of named ? rows.slice(1) : rows) {
    const id = row[named ? part : 0] ?? '';
    const number = Number(row[named ? count : 1]);
    if (/^[\w-]{1,20}$/.test(id) && Number.isInteger(number) && number > 0) {
      counts.set(id, Math.min(MAX_COUNT, (counts.get(id) ?? 0) + number));
    }
  }
  return counts;
}

function unquoted(cell: string): string {
  return cell.trim().replace(/^"(.*)"$/, '$1');
}
