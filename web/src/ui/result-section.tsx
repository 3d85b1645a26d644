import type { Problem } from '../model/report.ts';
import { fillWords } from '../tools/tool-words.ts';
import { CommandButton } from './controls.tsx';
import { Icon } from './icon.tsx';
import type { ResultState } from './page.ts';
import { usePage } from './page-context.ts';
import { formatNumber } from './text/language.ts';
import { text } from './text.ts';

const SHOWN_PROBLEMS = 12;

/** The verdict and the numbers of the model on screen. */
export function ResultSection() {
  const { result, stale, solve } = usePage();
  const shown = result.value;
  if (!shown) {
    return solve.value.phase === 'solving' ? null : (
      <section class="result-section">
        <p class="verdict none">
          <strong>{text.result.noModel}</strong>
          <span>{text.result.noModelText}</span>
        </p>
      </section>
    );
  }
  return (
    <section class={stale.value ? 'result-section stale' : 'result-section'}>
      {shown.final ? <Verdict result={shown} stale={stale.value} /> : null}
      {shown.final ? <Numbers result={shown} /> : null}
      {shown.final && shown.problems.length > 0 ? <Problems problems={shown.problems} /> : null}
    </section>
  );
}

function Verdict({ result, stale }: { readonly result: ResultState; readonly stale: boolean }) {
  const failed = result.items.filter((item) => !item.ok);
  const list = failed.map((item) => item.title.toLowerCase()).join('; ');
  const why = list === '' ? text.result.failedCount : fillWords(text.result.failedChecks, { list });
  const note = stale
    ? text.solve.stale
    : result.source === 'file'
      ? text.solve.fromFile
      : result.buildable
        ? text.result.buildableText
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
  const rows: readonly (readonly [string, number | undefined, string, boolean])[] = [
    [
      text.result.beams,
      report.beams,
      bound === undefined ? '' : fillWords(text.result.bound, { n: bound }),
      false,
    ],
    [text.result.bricks, report.bricks ?? result.bricks, '', false],
    [text.result.gaps, report.gaps, '', true],
    [text.result.collisions, report.collisions, '', true],
    [text.result.failedConnections, report.failedConnections, '', true],
    [text.result.uncovered, report.uncovered, '', true],
  ];
  return (
    <dl class="figures">
      {rows.map(([name, value, note, zeroIsGood]) =>
        value === undefined ? null : (
          <div key={name} class={zeroIsGood && value > 0 ? 'bad' : ''}>
            <dt>{name}</dt>
            <dd>
              {value}
              {note ? <small>{note}</small> : null}
            </dd>
          </div>
        ),
      )}
      <TimeAndMass result={result} />
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
          <dd>
            {size
              .map((value) => formatNumber(Math.round(value * 10) / 10, value % 1 === 0 ? 0 : 1))
              .join(' × ')}
          </dd>
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
              <span>{problem.message}</span>
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
