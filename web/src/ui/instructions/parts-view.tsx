import { countParts } from '../../model/counts.ts';
import { fillWords } from '../../tools/tool-words.ts';
import type { Book } from './book.ts';
import { instructionWords as words } from './instruction-words.ts';
import { PartTile } from './part-tile.tsx';

/** Every part with its picture, number and count. */
export function PartsView({ book }: { readonly book: Book }) {
  return (
    <section class="parts-view" aria-label={words.partsTitle}>
      <p class="quiet">{fillWords(words.cover.bricks, { n: book.model.parts.length })}</p>
      <ul class="parts-grid">
        {countParts(book.model).map((row) => (
          <PartTile key={`${row.part}/${row.color}`} row={row} shelf={book.shelf} named />
        ))}
      </ul>
    </section>
  );
}
