import { CommandButton } from './controls.tsx';
import { usePage } from './page-context.ts';
import { ProgressChart } from './progress-chart.tsx';
import { formatNumber } from './text/language.ts';
import { text } from './text.ts';

/** The button that starts the search, and everything about one under way. */
export function SolveSection() {
  const { solve, store, result, preferences, small } = usePage();
  const { phase } = solve.value;
  const empty = store.sketch.value.lines.length === 0;
  return (
    <section class="solve-section">
      {phase === 'solving' ? (
        <CommandButton id="cancel" words={text.solve.cancel} class="wide secondary" />
      ) : (
        <CommandButton
          id="generate"
          words={result.value ? text.solve.again : text.solve.generate}
          class="wide primary"
        />
      )}
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
      {empty ? <p class="quiet">{text.solve.empty}</p> : null}
      {!empty && !small.value && preferences.value.autoSolve && phase !== 'solving' ? (
        <p class="quiet">{text.solve.autoOff}</p>
      ) : null}
      <SolveMessage />
      <SolveProgressView />
    </section>
  );
}

function SolveMessage() {
  const { phase, message } = usePage().solve.value;
  if (message === '') {
    return null;
  }
  const bad = phase === 'refused' || phase === 'failed';
  return (
    <p class={bad ? 'note bad' : 'note'} role={bad ? 'alert' : 'status'}>
      {message}
    </p>
  );
}

function SolveProgressView() {
  const { phase, progress, chart } = usePage().solve.value;
  if (phase !== 'solving') {
    return null;
  }
  const fraction = progress?.fraction ?? 0;
  const name = progress
    ? (text.solve.phase[progress.phase] ?? progress.phase)
    : text.solve.starting;
  return (
    <div class="progress">
      <div class="progress-head">
        <span>{name}</span>
        <span class="quiet">
          {progress ? `${formatNumber(progress.iterations)} ${text.solve.iterations}` : ''}
        </span>
      </div>
      <progress max="1" value={fraction} aria-label={name} />
      {progress ? (
        <dl class="figures four">
          <Figure name={text.result.beams} value={progress.beams} />
          <Figure name={text.result.gaps} value={progress.gaps} />
          <Figure name={text.result.collisions} value={progress.collisions} />
          <Figure name={text.result.failedConnections} value={progress.failedConnections} />
        </dl>
      ) : null}
      {chart.length > 1 ? <ProgressChart points={chart} /> : null}
    </div>
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
