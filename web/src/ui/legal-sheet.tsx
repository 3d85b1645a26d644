import { fillWords } from '../tools/tool-words.ts';
import { Dialog } from './dialog.tsx';
import { usePage } from './page-context.ts';
import { SketchPicture } from './sketch-picture.tsx';
import { formatNumber } from './text/language.ts';
import { text } from './text.ts';

const SHOWN = 12;

/** The nearest drawing that can be built beside the one of a file that cannot: what moves, and one click to take it. */
export function LegalSheet() {
  const { legalOffer, dialog, takeLegal } = usePage();
  const offer = legalOffer.value;
  if (!offer) {
    return null;
  }
  const { changes, drawn, sketch } = offer;
  const most = Math.max(0, ...changes.map(({ moved }) => moved));
  const more = changes.length - SHOWN;
  return (
    <Dialog title={text.legal.title} class="legal">
      <p>
        {fillWords(text.legal.moved, {
          n: changes.length,
          all: sketch.lines.length,
          most: formatNumber(most, 2),
        })}
      </p>
      <div class="legal-pictures">
        <figure>
          <SketchPicture sketch={{ ...sketch, lines: drawn }} />
          <figcaption>{text.legal.before}</figcaption>
        </figure>
        <figure>
          <SketchPicture sketch={sketch} />
          <figcaption>{text.legal.after}</figcaption>
        </figure>
      </div>
      <ul>
        {changes.slice(0, SHOWN).map(({ line, before, after }) => (
          <li key={line}>
            {fillWords(text.legal.line, {
              n: line + 1,
              before: formatNumber(before, 2),
              after: formatNumber(after),
            })}
          </li>
        ))}
        {more > 0 ? <li>{fillWords(text.legal.more, { n: more })}</li> : null}
      </ul>
      <div class="dialog-bar">
        <button type="button" class="button primary" onClick={takeLegal}>
          {text.legal.take}
        </button>
        <button
          type="button"
          class="button secondary"
          onClick={() => {
            dialog.value = null;
          }}
        >
          {text.legal.leave}
        </button>
      </div>
    </Dialog>
  );
}
