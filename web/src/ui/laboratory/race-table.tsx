import { formatNumber } from '../text/language.ts';
import type { LabSketch } from './lab-sketches.ts';
import { laboratoryWords as words } from './laboratory-words.ts';
import { sketchName } from './race-chooser.tsx';
import type { MethodId } from './race-plan.ts';
import type { RaceResult } from './race-results.ts';

const NUMBERS = ['length', 'beams', 'bricks', 'gaps', 'collisions', 'failedConnections'] as const;

/** What all have ended with. */
export function RaceTable(props: {
  readonly results: readonly RaceResult[];
  readonly sketches: readonly LabSketch[];
}) {
  const { results, sketches } = props;
  const nameOf = (id: string) => {
    const sketch = sketches.find((one) => one.id === id);
    return sketch ? sketchName(sketch) : id;
  };
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached by the keys
    <section class="compare-scroll" tabIndex={0} aria-label={words.results}>
      <table class="compare">
        <caption class="visually-hidden">{words.results}</caption>
        <thead>
          <tr>
            <th scope="col">{words.sketch}</th>
            <th scope="col">{words.theMethod}</th>
            {NUMBERS.map((column) => (
              <th key={column} scope="col">
                {words.columns[column]}
              </th>
            ))}
            <th scope="col">{words.columns.buildable}</th>
            <th scope="col">{words.columns.seconds}</th>
          </tr>
        </thead>
        <tbody>
          {results.map((one) => (
            <tr key={`${one.sketch}/${one.method}`}>
              <th scope="row">{nameOf(one.sketch)}</th>
              <td>{words.method[one.method as MethodId]}</td>
              {NUMBERS.map((column) => (
                <td key={column}>{formatNumber(one[column])}</td>
              ))}
              <td>{one.buildable ? words.yes : words.no}</td>
              <td>{formatNumber(one.seconds, 1)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
