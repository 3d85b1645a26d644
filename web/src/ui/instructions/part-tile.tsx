import { useEffect, useRef } from 'preact/hooks';
import type { PutIn } from '../../instructions/build-steps.ts';
import { colourHex } from '../../model/colours.ts';
import type { PartCount } from '../../model/counts.ts';
import type { MeshShelf } from '../../view/drawing/drawn-part.ts';
import type { Picture } from '../../view/drawing/picture.ts';
import { colourWord, partName } from '../text/part-names.ts';
import type { Book } from './book.ts';
import { instructionWords as words } from './instruction-words.ts';
import { drawApart, drawPartPicture } from './step-picture.ts';

const SIZE = { width: 132, height: 84, margin: 4 } as const;
const pictures = new WeakMap<MeshShelf, Map<string, Picture>>();

function pictureOf(row: PartCount, shelf: MeshShelf): Picture {
  const known = pictures.get(shelf) ?? new Map<string, Picture>();
  pictures.set(shelf, known);
  const key = `${row.part}/${row.color}`;
  const picture = known.get(key) ?? drawPartPicture(row.part, colourHex(row.color), shelf, SIZE);
  known.set(key, picture);
  return picture;
}

/** A canvas that shows a picture. @param inputs what the picture depends on. */
function usePicture(picture: () => Picture, inputs: readonly unknown[]) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const { data, width, height } = picture();
    canvas.current?.getContext('2d')?.putImageData(new ImageData(data, width, height), 0, 0);
  }, inputs);
  return canvas;
}

/** A subassembly's picture with its count. */
export function ApartTile(props: {
  readonly book: Book;
  readonly index: number;
  readonly put: PutIn;
}) {
  const { book, index, put } = props;
  const canvas = usePicture(() => drawApart(book, index, put.parts, SIZE), [book, index, put]);
  return (
    <li class="part-tile" title={words.putIn}>
      <canvas ref={canvas} width={SIZE.width} height={SIZE.height} />
      <strong>{put.count}×</strong>
      <span class="part-apart">{words.putIn}</span>
    </li>
  );
}

/** A part's picture with its count. */
export function PartTile(props: {
  readonly row: PartCount;
  readonly shelf: MeshShelf;
  readonly named?: boolean;
}) {
  const { row, shelf, named } = props;
  const canvas = usePicture(() => pictureOf(row, shelf), [row, shelf]);
  const name = partName(row.part, shelf.catalogue);
  return (
    <li class="part-tile" title={`${name}, ${colourWord(row.color)}, ${row.part}`}>
      <canvas ref={canvas} width={SIZE.width} height={SIZE.height} />
      <strong>{row.count}×</strong>
      {named ? (
        <span>
          {name}
          <small class="quiet">
            {row.part}, {colourWord(row.color)}
          </small>
        </span>
      ) : (
        <span class="visually-hidden">{name}</span>
      )}
    </li>
  );
}
