import type { Problem, Report } from '../model/report.ts';
import { fillWords } from '../tools/tool-words.ts';
import { CommandButton } from './controls.tsx';
import { Icon } from './icon.tsx';
import type { ResultState } from './page.ts';
import { usePage } from './page-context.ts';
import { formatNumber } from './text/language.ts';
import { inWords } from './text/sentences.ts';
import { text } from './text.ts';

const SHOWN_PROBLEMS = 12;

/** The verdict and the numbers of the model on screen. */
export function ResultSection() {
  const { result, stale, solve, preferences, small } = usePage();
  const shown = result.value;
  const alone = preferences.value.autoSolve && small.value;
  if (!shown) {
    return solve.value.phase === 'solving' ? null : (
      <section class="result-section">
        <p class="verdict none">
          <strong>{text.result.noModel}</strong>
          <span>{alone ? text.result.noModelAuto : text.result.noModelText}</span>
        </p>
      </section>
    );
  }
  return (
    <section class={stale.value ? 'result-section stale' : 'result-section'}>
      {shown.final ? <Verdict result={shown} stale={stale.value} /> : null}
      {shown.final && shown.report.grown === true ? (
        <p class="quiet" data-testid="grown">
          {text.result.grown}
        </p>
      ) : null}
      {shown.final ? <Numbers result={shown} /> : null}
      {shown.final && shown.problems.length > 0 ? <Problems problems={shown.problems} /> : null}
    </section>
  );
}

function Verdict({ result, stale }: { readonly result: ResultState; readonly stale: boolean }) {
  const failed = result.items.filter((item) => !item.ok);
  const list = failed.map((item) => inWords(item.title).toLowerCase()).join('; ');
  const why = list === '' ? text.result.failedCount : fillWords(text.result.failedChecks, { list });
  const pieces = result.report.pieces ?? 1;
  const note = stale
    ? text.solve.stale
    : result.source === 'file'
      ? text.solve.fromFile
      : result.buildable
        ? fillWords(pieces > 1 ? text.result.buildablePieces : text.result.buildableText, {
            n: pieces,
          })
        : why;
  return (
    <p class={`verdict ${result.buildable ? 'ok' : 'bad'}`} role="status" data-testid="verdict">
      <Icon name={result.buildable ? 'check' : 'alert'} />
      <strong>{result.buildable ? text.result.buildable : text.result.notBuildable}</strong>
      <span>{note}</span>
    </p>
  );
}

function Numbers({ result }: { readonly result: ResultState }) {
  const { report } = result;
  const bound = report.beamsLowerBound;
  return (
    <>
      <dl class="figures">
        {report.beams === undefined ? null : (
          <div>
            <dt>{text.result.beams}</dt>
            <dd>
              {report.beams}
              {bound === undefined ? null : (
                <small>{fillWords(text.result.bound, { n: bound })}</small>
              )}
            </dd>
          </div>
        )}
        <div>
          <dt>{text.result.bricks}</dt>
          <dd>{report.bricks ?? result.bricks}</dd>
        </div>
        <TimeAndMass result={result} />
      </dl>
      <Shortcomings report={report} />
    </>
  );
}

/** What should be nothing: said in one line, and loudly where it is not. */
function Shortcomings({ report }: { readonly report: Report }) {
  const rows: readonly (readonly [string, number | undefined])[] = [
    [text.result.gaps, report.gaps],
    [text.result.collisions, report.collisions],
    [text.result.failedConnections, report.failedConnections],
    [text.result.uncovered, report.uncovered],
  ];
  return (
    <dl class="shortcomings">
      {rows.map(([name, value]) =>
        value === undefined ? null : (
          <div key={name} class={value > 0 ? 'bad' : ''}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ),
      )}
    </dl>
  );
}

function TimeAndMass({ result }: { readonly result: ResultState }) {
  const { seconds, mass, size } = result.report;
  return (
    <>
      {seconds ? (
        <div>
          <dt>{text.result.seconds}</dt>
          <dd>{fillWords(text.result.secondsText, { n: formatNumber(seconds.total, 2) })}</dd>
        </div>
      ) : null}
      {mass ? (
        <div>
          <dt>{text.result.mass}</dt>
          <dd>{fillWords(text.result.massText, { n: formatNumber(mass) })}</dd>
        </div>
      ) : null}
      {size ? (
        <div class="span">
          <dt>{text.result.size}</dt>
          <dd>{size.map(sizeText).join(' × ')}</dd>
        </div>
      ) : null}
    </>
  );
}

function Problems({ problems }: { readonly problems: readonly Problem[] }) {
  const page = usePage();
  const more = problems.length - SHOWN_PROBLEMS;
  return (
    <div class="problems">
      <h3>{text.result.problems}</h3>
      <ul>
        {problems.slice(0, SHOWN_PROBLEMS).map((problem, i) => (
          <li key={`${problem.kind}${problem.message}`}>
            <button
              type="button"
              class="problem"
              aria-pressed={page.focusedProblem.value === i}
              onClick={() => page.focusProblem(i)}
            >
              <Icon name="alert" />
              <span>{inWords(problem.message)}</span>
            </button>
          </li>
        ))}
      </ul>
      <div class="mends">
        <CommandButton id="newSeed" words={text.result.trySeed} class="secondary small" />
        <CommandButton id="searchLonger" words={text.result.tryLonger} class="secondary small" />
      </div>
      {more > 0 ? <p class="quiet">{fillWords(text.result.more, { n: more })}</p> : null}
    </div>
  );
}

/** Modules to one decimal, where there is one. */
function sizeText(value: number): string {
  const rounded = Math.round(value * 10) / 10;
  return formatNumber(rounded, Number.isInteger(rounded) ? 0 : 1);
}
