import {
  PDFDocument,
  type PDFFont,
  type PDFImage,
  type PDFPage,
  rgb,
  StandardFonts,
} from 'pdf-lib';
import { modelBounds } from '../../../model/bounds.ts';
import { colourHex } from '../../../model/colours.ts';
import { countParts, modelMass, type PartCount } from '../../../model/counts.ts';
import { fillWords } from '../../../tools/tool-words.ts';
import { cameraFor, ISO_OUT } from '../../../view/drawing/drawing-camera.ts';
import { drawn } from '../../../view/drawing/drawn-part.ts';
import { drawPicture, type Picture } from '../../../view/drawing/picture.ts';
import { pictureBlob } from '../../share/picture-blob.ts';
import { formatNumber } from '../../text/language.ts';
import { colourWord, partName } from '../../text/part-names.ts';
import type { Book } from '../book.ts';
import { instructionWords as words } from '../instruction-words.ts';
import { arrowPath } from '../step-canvas.tsx';
import { notesOf } from '../step-notes.ts';
import { drawApart, drawPartPicture, drawStep } from '../step-picture.ts';
import {
  MARGIN,
  PAPERS,
  type PageBox,
  type PaperName,
  pageSteps,
  partCell,
  partsOnPage,
  printable,
  stepBoxes,
  wrap,
} from './paper.ts';

/** Pixels of a picture for one point: 200 dots an inch. */
const DENSITY = 200 / 72;
/** Pixels of a part's picture. */
const PART_PICTURE = { width: 396, height: 252, margin: 6 } as const;
const INK = rgb(0.1, 0.11, 0.14);
const QUIET = rgb(0.34, 0.37, 0.42);
const BOX = rgb(0.89, 0.93, 0.99);
/** Behind steps of subassemblies. */
const APART = rgb(1, 0.985, 0.935);
const ACCENT = rgb(1, 0.48, 0);
const WARN = rgb(0.54, 0.32, 0);

interface Press {
  readonly book: Book;
  readonly paper: PaperName;
  readonly pdf: PDFDocument;
  readonly plain: PDFFont;
  readonly bold: PDFFont;
  /** Pictures of parts, made once. */
  readonly parts: Map<string, PDFImage>;
}

/** The whole book as a PDF. Words, boxes and arrows are vectors; bricks are pictures. */
export async function makePdf(
  book: Book,
  paper: PaperName,
  onPage: (n: number, all: number) => void,
): Promise<Blob> {
  const pdf = await PDFDocument.create();
  pdf.setTitle(book.title);
  pdf.setCreator('Liftarm');
  const press: Press = {
    book,
    paper,
    pdf,
    plain: await pdf.embedFont(StandardFonts.Helvetica),
    bold: await pdf.embedFont(StandardFonts.HelveticaBold),
    parts: new Map(),
  };
  const list = countParts(book.model);
  const fit = partsOnPage(paper);
  const listPages = Math.ceil(list.length / fit);
  const steps = pageSteps(book.steps.length);
  const all = 1 + listPages + steps.length;
  onPage(1, all);
  await coverPage(press);
  for (let i = 0; i < listPages; i++) {
    onPage(2 + i, all);
    await partsPage(press, list.slice(i * fit, (i + 1) * fit));
  }
  for (const [i, indices] of steps.entries()) {
    onPage(2 + listPages + i, all);
    await stepsPage(press, indices);
  }
  pdf.getPages().forEach((page, i) => {
    if (i > 0) {
      const text = fillWords(words.page, { n: i + 1, all });
      const x = PAPERS[paper][0] / 2 - press.plain.widthOfTextAtSize(text, 9) / 2;
      page.drawText(text, { x, y: MARGIN - 12, size: 9, font: press.plain, color: QUIET });
    }
  });
  const bytes = await pdf.save();
  return new Blob([bytes as Uint8Array<ArrayBuffer>], { type: 'application/pdf' });
}

async function embed(press: Press, picture: Picture): Promise<PDFImage> {
  const jpeg = await pictureBlob(picture, 'image/jpeg');
  return press.pdf.embedJpg(await jpeg.arrayBuffer());
}

function write(
  press: Press,
  page: PDFPage,
  text: string,
  at: {
    readonly x: number;
    readonly y: number;
    readonly size: number;
    readonly strong?: boolean;
    readonly quiet?: boolean;
  },
): number {
  const font = at.strong ? press.bold : press.plain;
  const safe = printable(text);
  page.drawText(safe, { x: at.x, y: at.y, size: at.size, font, color: at.quiet ? QUIET : INK });
  return font.widthOfTextAtSize(safe, at.size);
}

async function coverPage(press: Press): Promise<void> {
  const { book, paper } = press;
  const [width, height] = PAPERS[paper];
  const page = press.pdf.addPage([width, height]);
  const parts = book.model.parts.map(drawn);
  const box = { width: width - 2 * MARGIN, height: height * 0.6 };
  const size = {
    width: Math.round(box.width * DENSITY),
    height: Math.round(box.height * DENSITY),
    margin: 20,
  };
  const points = parts.flatMap((part) => book.shelf.corners(part));
  const picture = drawPicture(parts, cameraFor(points, ISO_OUT, size), book.shelf);
  page.drawImage(await embed(press, picture), { x: MARGIN, y: height * 0.22, ...box });
  page.drawRectangle({ x: 0, y: height - 110, width, height: 110, color: rgb(0.11, 0.37, 0.82) });
  const title = printable(book.title);
  const fit = Math.min(40, (width - 2 * MARGIN) / press.bold.widthOfTextAtSize(title, 1));
  page.drawText(title, {
    x: MARGIN,
    y: height - 70,
    size: fit,
    font: press.bold,
    color: rgb(1, 1, 1),
  });
  const facts = coverFacts(book);
  write(press, page, facts, { x: MARGIN, y: height * 0.17, size: 14 });
  write(press, page, words.legal, { x: MARGIN, y: MARGIN, size: 8, quiet: true });
}

function coverFacts(book: Book): string {
  const bounds = modelBounds(book.model, book.shelf.catalogue);
  const cm = (k: 0 | 1 | 2) => formatNumber(bounds ? (bounds.max[k] - bounds.min[k]) * 0.8 : 0, 1);
  return [
    fillWords(words.cover.bricks, { n: book.model.parts.length }),
    fillWords(words.cover.steps, { n: book.steps.length }),
    fillWords(words.cover.size, { x: cm(0), y: cm(1), z: cm(2) }),
    fillWords(words.cover.mass, {
      n: formatNumber(modelMass(book.model, book.shelf.catalogue)),
    }),
  ].join('   ·   ');
}

async function partImage(press: Press, row: PartCount): Promise<PDFImage> {
  const key = `${row.part}/${row.color}`;
  const known = press.parts.get(key);
  if (known) {
    return known;
  }
  const picture = drawPartPicture(row.part, colourHex(row.color), press.book.shelf, PART_PICTURE);
  const image = await embed(press, picture);
  press.parts.set(key, image);
  return image;
}

async function partsPage(press: Press, list: readonly PartCount[]): Promise<void> {
  const [width, height] = PAPERS[press.paper];
  const page = press.pdf.addPage([width, height]);
  write(press, page, words.partsTitle, {
    x: MARGIN,
    y: height - MARGIN - 20,
    size: 22,
    strong: true,
  });
  const cell = partCell(press.paper, list.length);
  for (const [i, row] of list.entries()) {
    const x = MARGIN + 4 + (i % cell.columns) * cell.width;
    const top = height - MARGIN - 40 - cell.height * Math.floor(i / cell.columns);
    const y = top - cell.picture.height;
    page.drawImage(await partImage(press, row), { x, y, ...cell.picture });
    const count = write(press, page, `${row.count}x`, { x, y: y - 18, size: 18, strong: true });
    write(press, page, row.part, { x: x + count + 10, y: y - 18, size: 11 });
    const name = partName(row.part, press.book.shelf.catalogue);
    // The colour first: what is cut off of a long name says less.
    const title = `${colourWord(row.color)}: ${name}`;
    const lines = wrap(printable(title), cell.width - 12, (line) =>
      press.plain.widthOfTextAtSize(line, 10),
    );
    for (const [k, line] of lines.entries()) {
      write(press, page, line, { x, y: y - 31 - 11 * k, size: 10, quiet: true });
    }
  }
}

async function stepsPage(press: Press, indices: readonly number[]): Promise<void> {
  const [width, height] = PAPERS[press.paper];
  const page = press.pdf.addPage([width, height]);
  const boxes = stepBoxes(press.paper, indices.length);
  for (const [i, index] of indices.entries()) {
    const box = boxes[i];
    if (box) {
      await stepBox(press, page, index, box);
    }
  }
  const [upper, lower] = boxes;
  if (upper && lower) {
    const y = upper.y - 8;
    page.drawLine({
      start: { x: MARGIN, y },
      end: { x: width - MARGIN, y },
      thickness: 0.5,
      color: rgb(0.8, 0.82, 0.86),
    });
  }
}

async function stepBox(press: Press, page: PDFPage, index: number, box: PageBox): Promise<void> {
  const { book } = press;
  const step = book.steps[index];
  if (!step) {
    return;
  }
  const apart = step.group.id !== 0;
  if (apart) {
    page.drawRectangle({
      x: box.x - 12,
      y: box.y - 2,
      width: box.width + 24,
      height: box.height + 8,
      color: APART,
      borderColor: rgb(0.88, 0.8, 0.62),
      borderWidth: 0.7,
    });
  }
  const used = await partsBox(press, page, index, box);
  const place = { x: box.x, y: box.y, width: box.width, height: box.height - used - 6 };
  const size = {
    width: Math.round(place.width * DENSITY),
    height: Math.round(place.height * DENSITY),
    margin: 24,
    maxScale: 24 * DENSITY,
  };
  const { picture, arrows } = drawStep(book, index, size);
  const image = await embed(press, picture);
  page.drawImage(image, apart ? { ...place, blendMode: MULTIPLY } : place);
  for (const arrow of arrows) {
    const path = arrowPath(
      {
        x1: arrow.x1 / DENSITY,
        y1: arrow.y1 / DENSITY,
        x2: arrow.x2 / DENSITY,
        y2: arrow.y2 / DENSITY,
      },
      5,
      11,
    );
    page.drawSvgPath(path, { x: place.x, y: place.y + place.height, color: ACCENT });
  }
}

/** Number, parts and notes above a step's picture. @returns how high they are, points. */
async function partsBox(press: Press, page: PDFPage, index: number, box: PageBox): Promise<number> {
  const { book } = press;
  const step = book.steps[index];
  if (!step) {
    return 0;
  }
  const top = box.y + box.height;
  const number = write(press, page, `${step.number}`, {
    x: box.x,
    y: top - 34,
    size: 40,
    strong: true,
  });
  const left = box.x + Math.max(60, number + 14);
  const perRow = Math.max(1, Math.floor((box.x + box.width - left) / 74));
  const tiles = await tilesOf(press, index);
  const rows = Math.max(1, Math.ceil(tiles.length / perRow));
  const height = rows * 52 + 6;
  if (tiles.length > 0) {
    const columns = Math.min(perRow, tiles.length);
    page.drawRectangle({
      x: left,
      y: top - height,
      width: columns * 74 + 6,
      height,
      color: BOX,
      borderColor: rgb(0.6, 0.7, 0.86),
      borderWidth: 0.7,
    });
    for (const [i, { image, count }] of tiles.entries()) {
      const x = left + 4 + (i % perRow) * 74;
      const y = top - 4 - Math.floor(i / perRow) * 52;
      page.drawImage(image, { x, y: y - 40, width: 63, height: 40, blendMode: MULTIPLY });
      write(press, page, `${count}x`, { x: x + 2, y: y - 48, size: 11, strong: true });
    }
  }
  const notes = linesOf(book, index);
  notes.forEach((note, i) => {
    page.drawText(printable(note), {
      x: box.x,
      y: top - height - 15 - 15 * i,
      size: 12,
      font: press.bold,
      color: WARN,
    });
  });
  return height + 15 * notes.length;
}

/** What a step takes: parts, and subassemblies that are finished. */
async function tilesOf(press: Press, index: number): Promise<{ image: PDFImage; count: number }[]> {
  const step = press.book.steps[index];
  const tiles: { image: PDFImage; count: number }[] = [];
  for (const row of step?.loose ?? []) {
    tiles.push({ image: await partImage(press, row), count: row.count });
  }
  for (const { parts, count } of step?.putIns ?? []) {
    const picture = drawApart(press.book, index, parts, PART_PICTURE);
    tiles.push({ image: await embed(press, picture), count });
  }
  return tiles;
}

/** White of a picture vanishes on a coloured box. */
const MULTIPLY = 'Multiply' as NonNullable<Parameters<PDFPage['drawImage']>[1]>['blendMode'] &
  string;

function linesOf(book: Book, index: number): string[] {
  const { apart, turned, warnings } = notesOf(book, index);
  const put = book.steps[index]?.putIns.length ?? 0;
  return [
    ...(apart.length > 0 ? [apart.join('  ·  ')] : []),
    ...(put > 0 ? [words.putIn] : []),
    ...(turned ? [turned] : []),
    ...warnings,
  ];
}
