import { fillWords } from '../tools/tool-words.ts';
import { usePage } from './page-context.ts';
import { formatNumber } from './text/language.ts';
import { text } from './text.ts';

/** The best layouts that the last search came by, to go back to. */
export function LayoutList() {
  const page = usePage();
  const { layouts, phase } = page.solve.value;
  const shown = page.shown.value?.json;
  if (phase === 'solving' || layouts.length < 2) {
    return null;
  }
  return (
    <div class="layouts">
      <h4>{text.solve.layouts}</h4>
      <ol>
        {layouts.map((layout, i) => (
          <li key={layout.iterations}>
            <button
              type="button"
              aria-pressed={layout.json === shown}
              title={fillWords(text.solve.layoutText, {
                beams: layout.beams,
                gaps: layout.gaps,
                failed: layout.failedConnections,
              })}
              onClick={() => page.showLayout(layout)}
            >
              <span class="quiet">{i + 1}</span>
              <b>{formatNumber(layout.objective, 1)}</b>
              <span class="quiet">{fillWords(text.solve.layoutBeams, { n: layout.beams })}</span>
            </button>
          </li>
        ))}
      </ol>
    </div>
  );
}
