import { bad, good, type Outcome } from '../base/outcome.ts';
import { linesOf, separatorOf, tableOf } from './delimited.ts';
import { knownNumber } from './part-synonyms.ts';

/** More rows than this are no parts list. */
const MAX_ROWS = 20_000;
const MAX_COUNT = 100_000;
/** Titles and notes may stand above the names of the columns, but no more of them. */
const MAX_TITLES = 30;

/** Names of the column with part numbers, letters and digits alone; the earlier one counts where there are several. */
const PART_NAMES = [
  ...['ldrawid', 'ldrawpartid', 'ldraw', 'partnum', 'partnumber', 'partno', 'partid'],
  ...['itemno', 'itemnumber', 'itemid', 'blitemno', 'bricklinkid', 'blid', 'designid', 'designno'],
  ...['teilenummer', 'teilenr', 'teilnummer', 'part', 'design', 'item', 'teil', 'id'],
];
const COUNT_NAMES = [
  ...['quantity', 'qty', 'count', 'minqty', 'pieces', 'pcs', 'amount', 'have', 'owned'],
  ...['anzahl', 'menge', 'stück', 'stueck', 'stückzahl'],
];
/** Either of them: whichever the other columns leave. */
const EITHER_NAMES = ['number', 'nummer', 'no', 'nr'];

/** A row from which nothing can be taken, and why: its part is not known, or its count is none. */
export interface OddRow {
  /** From 1. */
  readonly row: number;
  readonly text: string;
  readonly why: 'part' | 'count';
}

/** What a list of parts says. */
export interface PartsList {
  /** By the number under which a part is known here; colours are added up. */
  readonly counts: ReadonlyMap<string, number>;
  /** Rows that name a part, understood or not. */
  readonly rows: number;
  readonly odd: readonly OddRow[];
}

/** One row, as it stands there. */
interface Entry {
  readonly row: number;
  readonly text: string;
  readonly part: string;
  readonly count: number;
}

/**
 * Reads a list of owned parts: tables (comma, semicolon or tab; columns by their names, in any order), lists in XML as
 * shops and collectors write them, or plain rows such as `32524 8` and `4x 43857`.
 * @param known the numbers of all parts that there are.
 * @returns one sentence where nothing in it is a list.
 */
export function readPartsList(text: string, known: ReadonlySet<string>): Outcome<PartsList> {
  const lines = linesOf(text);
  if (lines.every((line) => line.trim() === '')) {
    return bad('the file is empty');
  }
  if (lines.length > MAX_ROWS) {
    return bad(`the list has more than ${MAX_ROWS} rows, which is the limit`);
  }
  const entries = /<item\b/i.test(text) ? xmlEntries(text) : rowEntries(lines, known);
  return entries.length > 0
    ? good(listOf(entries, known))
    : bad('no row has a part number and a count, such as "32524,8"');
}

function listOf(entries: readonly Entry[], known: ReadonlySet<string>): PartsList {
  const counts = new Map<string, number>();
  const odd: OddRow[] = [];
  for (const { row, text, part, count } of entries) {
    const id = knownNumber(part, known);
    if (id === null || !(Number.isInteger(count) && count > 0)) {
      odd.push({ row, text: text.trim().slice(0, 80), why: id === null ? 'part' : 'count' });
    } else {
      counts.set(id, Math.min(MAX_COUNT, (counts.get(id) ?? 0) + count));
    }
  }
  return { counts, rows: entries.length, odd };
}

/** BrickLink's and BrickStore's inventories: parts alone, by what is there or else by what is wanted. */
function xmlEntries(text: string): Entry[] {
  const items = [...text.matchAll(/<item\b[^>]*>([\s\S]*?)<\/item>/gi)];
  return items.flatMap((match, i) => {
    const field = (name: string) =>
      new RegExp(`<${name}>\\s*([^<]*?)\\s*</${name}>`, 'i').exec(match[1] ?? '')?.[1] ?? '';
    const type = field('itemtype') || field('itemtypeid') || 'P';
    const count = field('qty') || field('minqty') || '1';
    const part = field('itemid');
    return type.toUpperCase() === 'P' && part !== ''
      ? [{ row: i + 1, text: `${part} ${count}`, part, count: countOf(count) }]
      : [];
  });
}

function rowEntries(lines: readonly string[], known: ReadonlySet<string>): Entry[] {
  const separator = separatorOf(lines);
  if (separator !== null) {
    const table = tableOf(lines, separator);
    const head = table.slice(0, MAX_TITLES).findIndex((cells) => columnsOf(cells) !== null);
    const columns = columnsOf(table[head] ?? []);
    if (columns) {
      return table.slice(head + 1).flatMap((cells, i) => {
        const part = cells[columns.part] ?? '';
        const row = head + 1 + i;
        // Totals and empty rows name no part.
        return part === ''
          ? []
          : [
              {
                row: row + 1,
                text: cells.join(separator),
                part,
                count: countOf(cells[columns.count] ?? ''),
              },
            ];
      });
    }
  }
  return lines.flatMap((line, i) => plainEntry(line, i + 1, known) ?? []);
}

/** Which columns hold part numbers and counts, by their names; null where a row names none. */
function columnsOf(cells: readonly string[]): { part: number; count: number } | null {
  const names = cells.map((cell) => cell.toLowerCase().replace(/[^\p{L}\p{N}]/gu, ''));
  const find = (wanted: readonly string[]) =>
    wanted.map((name) => names.indexOf(name)).find((at) => at >= 0) ?? -1;
  const either = find(EITHER_NAMES);
  const part = find(PART_NAMES);
  const count = find(COUNT_NAMES);
  if (part >= 0) {
    return count >= 0 || either >= 0 ? { part, count: count >= 0 ? count : either } : null;
  }
  return either >= 0 && count >= 0 ? { part: either, count } : null;
}

/** `32524 8`, `32316 x 6`, `2780: 60`, `4x 43857`: a part number and a count, in either order. */
function plainEntry(line: string, row: number, known: ReadonlySet<string>): Entry | null {
  const words = line
    .split(/[\s,;:\t]+/)
    .map((word) => word.replace(/^"(.*)"$/, '$1'))
    .filter((word) => word !== '' && !/^[x×*]$/i.test(word));
  const [first = '', second = ''] = words;
  if (words.length < 2) {
    return null;
  }
  const turned = knownNumber(first, known) === null && knownNumber(second, known) !== null;
  const [part, count] = turned ? [second, first] : [first, second];
  return /\d/.test(part) && Number.isInteger(countOf(count))
    ? { row, text: line, part, count: countOf(count) }
    : null;
}

/** A count as people and programs write it: `4`, `4.0`, `1,200`, `x12`, `12x`. NaN where it is none. */
function countOf(cell: string): number {
  const plain = cell.trim().replace(/^[x×]\s*|\s*[x×]$/gi, '');
  if (/^\d+(?:[.,]0{1,2})?$/.test(plain)) {
    return Number.parseInt(plain, 10);
  }
  return /^\d{1,3}(?:[.,'’ ]\d{3})+$/.test(plain) ? Number(plain.replace(/\D/g, '')) : Number.NaN;
}
