import type { Problem, Report } from '../model/report.ts';
import { fillWords } from '../tools/tool-words.ts';
import { CommandButton } from './controls.tsx';
import { placesInWords } from './fault-words.ts';
import { Icon } from './icon.tsx';
import type { ResultState } from './page.ts';
import { usePage } from './page-context.ts';
import { formatNumber } from './text/language.ts';
import { inWords } from './text/sentences.ts';
import { text } from './text.ts';

const SHOWN_PROBLEMS = 12;

/** The figures of the model on screen. The verdict on it stands above (verdict-card.tsx). */
export function ResultSection({ result }: { readonly result: ResultState }) {
  const { stale, solve } = usePage();
  const past = stale.value || solve.value.phase === 'solving';
  return (
    <section class={past ? 'result-section stale' : 'result-section'}>
      <Numbers result={result} />
      {result.report.grown === true ? (
        <p class="quiet" data-testid="grown">
          {text.result.grown}
        </p>
      ) : null}
    </section>
  );
}

/** All that is wrong with the model, each with its place. */
export function ProblemSection({ result }: { readonly result: ResultState }) {
  const { stale } = usePage();
  return result.problems.length === 0 ? null : (
    <section class={stale.value ? 'result-section stale' : 'result-section'}>
      <Problems problems={result.problems} />
    </section>
  );
}

/** What should be nothing, and the fewest beams that any parts in use could do with. */
export function FigureSection({ result }: { readonly result: ResultState }) {
  const { stale } = usePage();
  const { beamsLowerBound: bound } = result.report;
  return (
    <section class={stale.value ? 'result-section stale' : 'result-section'}>
      <Shortcomings report={result.report} />
      {bound === undefined ? null : (
        <p class="quiet">{fillWords(text.result.bound, { n: bound })}</p>
      )}
    </section>
  );
}

function Numbers({ result }: { readonly result: ResultState }) {
  const { report } = result;
  return (
    <dl class="figures">
      {report.beams === undefined ? null : (
        <div>
          <dt>{text.result.beams}</dt>
          <dd>{report.beams}</dd>
        </div>
      )}
      <div>
        <dt>{text.result.bricks}</dt>
        <dd>{report.bricks ?? result.bricks}</dd>
      </div>
      <TimeAndMass result={result} />
    </dl>
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
              <span>{placesInWords(inWords(problem.message))}</span>
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
