/** Rows of a table as text: cells parted by one sign, quoted where they hold it, with any end of line. */
import Papa from 'papaparse';

const SEPARATORS = ['\t', ';', ','] as const;
const SEP_LINE = /^sep=(.)$/i;

export function linesOf(text: string): string[] {
  return text.replace(/^\uFEFF/, '').split(/\r\n|\n|\r/);
}

/** What parts the cells: said in the first row by some programs, else what the most rows have; null for plain rows. */
export function separatorOf(lines: readonly string[]): string | null {
  const said = SEP_LINE.exec(lines[0]?.trim() ?? '')?.[1];
  if (said) {
    return said;
  }
  const bare = lines.map((line) => line.replace(/"[^"]*"/g, ''));
  const counts = SEPARATORS.map((sign) => bare.filter((line) => line.includes(sign)).length);
  const most = Math.max(...counts);
  return most === 0 ? null : (SEPARATORS[counts.indexOf(most)] ?? null);
}

/** The cells of every row, without quotes and the white space round them; a quoted cell may go over several lines. */
export function tableOf(lines: readonly string[], separator: string): string[][] {
  const { data } = Papa.parse<string[]>(lines.join('\n'), { delimiter: separator, newline: '\n' });
  return data.map((cells) => cells.map((cell) => cell.trim()));
}
