export type PaperName = 'A4' | 'Letter';

/** Width and height in points (1/72 inch), upright. */
export const PAPERS: Readonly<Record<PaperName, readonly [number, number]>> = {
  A4: [595.28, 841.89],
  Letter: [612, 792],
};

export const MARGIN = 36;

/** Only what the built-in fonts can write: others become a question mark. */
export function printable(text: string): string {
  return text
    .normalize('NFC')
    .replaceAll('…', '...')
    .replaceAll('–', '-')
    .replace(/[^\x20-\x7e\xa0-\xff]/gu, '?');
}

/** A box on a page: points from the lower left corner. */
export interface PageBox {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Where the steps of a page are: one has all of it, two have its upper and lower half. */
export function stepBoxes(paper: PaperName, count: number): readonly PageBox[] {
  const [width, height] = PAPERS[paper];
  const inner = height - 2 * MARGIN - 16;
  const half = inner / 2;
  const box = (y: number, high: number): PageBox => ({
    x: MARGIN,
    y,
    width: width - 2 * MARGIN,
    height: high - 8,
  });
  return count === 1
    ? [box(MARGIN + 16, inner)]
    : [box(MARGIN + 16 + half + 8, half), box(MARGIN + 16, half)];
}

/** Where a part of the list is: three in a row can still be told apart at arm's length. Points. */
export interface PartCell {
  readonly columns: number;
  readonly width: number;
  readonly height: number;
  readonly picture: { readonly width: number; readonly height: number };
}

const LEAST_CELL = { columns: 3, height: 140 } as const;
const PICTURE_SHAPE = 63 / 40;
/** Count, number and three lines of the name below a picture. */
const CELL_WORDS = 62;
const LARGEST_PICTURE = 210;

/** Height of a page's parts, below its title. */
function partsRoom(paper: PaperName): number {
  return PAPERS[paper][1] - 2 * MARGIN - 60;
}

/** How many parts of the list fit a page. */
export function partsOnPage(paper: PaperName): number {
  return LEAST_CELL.columns * Math.floor(partsRoom(paper) / LEAST_CELL.height);
}

/** Cells in which so many parts have the largest pictures that one page has room for. */
export function partCell(paper: PaperName, count: number): PartCell {
  const cells = [LEAST_CELL.columns, 2].map((columns): PartCell => {
    const width = (PAPERS[paper][0] - 2 * MARGIN) / columns;
    const room = partsRoom(paper) / Math.ceil(Math.max(1, count) / columns);
    const wide = Math.min(width - 12, LARGEST_PICTURE, (room - CELL_WORDS) * PICTURE_SHAPE);
    const picture = { width: wide, height: wide / PICTURE_SHAPE };
    return { columns, width, height: Math.min(room, picture.height + CELL_WORDS + 12), picture };
  });
  return cells.reduce((best, cell) => (cell.picture.width > best.picture.width ? cell : best));
}

/** Pages of the book: which steps share one. */
export function pageSteps(count: number): number[][] {
  const pages: number[][] = [];
  for (let i = 0; i < count; i += 2) {
    pages.push(i + 1 < count ? [i, i + 1] : [i]);
  }
  return pages;
}

const MOST_LINES = 3;

/**
 * Breaks words into at most three lines.
 * @param widthOf of a text in the wanted font
 * @returns the lines; what does not fit into the last ends with dots.
 */
export function wrap(text: string, width: number, widthOf: (line: string) => number): string[] {
  const words = text.split(' ');
  const lines: string[] = [];
  while (words.length > 0 && lines.length < MOST_LINES - 1) {
    let line = words.shift() ?? '';
    while (words[0] !== undefined && widthOf(`${line} ${words[0]}`) <= width) {
      line += ` ${words.shift()}`;
    }
    lines.push(line);
  }
  return [...lines, words.join(' ')]
    .filter((line) => line !== '')
    .map((line) => cut(line, width, widthOf));
}

function cut(line: string, width: number, widthOf: (line: string) => number): string {
  let shown = line;
  while (shown.length > 4 && widthOf(shown) > width) {
    shown = `${shown.slice(0, -4)}...`;
  }
  return shown;
}
