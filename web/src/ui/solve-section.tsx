import { CommandButton } from './controls.tsx';
import { usePage } from './page-context.ts';
import { ProgressChart } from './progress-chart.tsx';
import { text } from './text.ts';

/** The button that starts the search, or stops the one under way; both have the same place. */
export function SolveSection() {
  const { solve, store, result, preferences } = usePage();
  const { phase } = solve.value;
  const empty = store.sketch.value.lines.length === 0;
  return (
    <section class="solve-section">
      {phase === 'solving' ? (
        <CommandButton id="cancel" words={text.solve.cancel} class="wide" />
      ) : (
        <CommandButton
          id="generate"
          words={result.value ? text.solve.again : text.solve.generate}
          class="wide primary"
        />
      )}
      {empty ? (
        <p class="quiet">{text.solve.empty}</p>
      ) : (
        <label class="check-row">
          <input
            type="checkbox"
            checked={preferences.value.autoSolve}
            onChange={(event) => {
              preferences.value = { ...preferences.peek(), autoSolve: event.currentTarget.checked };
            }}
          />
          <span>{text.solve.auto}</span>
        </label>
      )}
    </section>
  );
}

/** The course of a search that takes long enough to be watched. */
export function SearchUnderWay() {
  const { phase, progress, chart } = usePage().solve.value;
  if (phase !== 'solving' || !progress) {
    return null;
  }
  return (
    <section class="progress">
      <dl class="figures four">
        <Figure name={text.result.beams} value={progress.beams} />
        <Figure name={text.result.gaps} value={progress.gaps} />
        <Figure name={text.result.collisions} value={progress.collisions} />
        <Figure name={text.result.failedConnections} value={progress.failedConnections} />
      </dl>
      {chart.length > 1 ? <ProgressChart points={chart} /> : null}
    </section>
  );
}

function Figure({ name, value }: { readonly name: string; readonly value: number }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{value}</dd>
    </div>
  );
}
