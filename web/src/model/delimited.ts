/** Rows of a table as text: cells parted by one sign, quoted where they hold it, with any end of line. */

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

/** The cells of one row, without quotes and the white space round them. */
export function cellsOf(line: string, separator: string): string[] {
  const cells: string[] = [];
  let cell = '';
  let quoted = false;
  for (let i = 0; i < line.length; i++) {
    const sign = line[i];
    if (sign === '"') {
      // Two in a quoted cell are one of its own.
      if (quoted && line[i + 1] === '"') {
        cell += '"';
        i += 1;
      } else {
        quoted = !quoted;
      }
    } else if (sign === separator && !quoted) {
      cells.push(cell.trim());
      cell = '';
    } else {
      cell += sign;
    }
  }
  return [...cells, cell.trim()];
}
