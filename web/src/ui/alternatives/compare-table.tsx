import { fillWords } from '../../tools/tool-words.ts';
import { formatNumber } from '../text/language.ts';
import { alternativeWords as words } from './alternative-words.ts';
import { FIGURES, type FigureId, type Figures } from './alternatives.ts';
import type { Compared } from './alternatives-view.tsx';

const DIGITS: Readonly<Record<FigureId, number>> = {
  bricks: 0,
  kinds: 0,
  deviation: 2,
  freedoms: 0,
  mass: 0,
};

/** A row a model; the least of each figure stands out. */
export function CompareTable({ all }: { readonly all: readonly Compared[] }) {
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached by the keys
    <section class="compare-scroll" tabIndex={0} aria-label={words.compare}>
      <table class="compare">
        <caption class="visually-hidden">{words.compare}</caption>
        <thead>
          <tr>
            <th scope="col">{words.model}</th>
            {FIGURES.map((figure) => (
              <th key={figure} scope="col">
                {words.figures[figure]}
              </th>
            ))}
            <th scope="col">{words.wellBuilt}</th>
          </tr>
        </thead>
        <tbody>
          {all.map((one) => (
            <tr key={one.key}>
              <th scope="row">{one.name}</th>
              {FIGURES.map((figure) => (
                <td key={figure} class={one.best.has(figure) ? 'best' : ''}>
                  {figureText(one.figures, figure)}
                </td>
              ))}
              <td>{wellBuiltText(one.figures)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

function figureText(figures: Figures, figure: FigureId): string {
  const value = figures[figure];
  return value === null ? '–' : formatNumber(value, DIGITS[figure]);
}

function wellBuiltText({ wellBuilt }: Figures): string {
  return wellBuilt ? fillWords(words.wellBuiltValue, { n: wellBuilt[0], all: wellBuilt[1] }) : '–';
}
