import { fillWords } from '../../tools/tool-words.ts';
import type { MeshShelf } from '../../view/drawing/drawn-part.ts';
import { ModelPicture } from '../alternatives/model-picture.tsx';
import { formatNumber } from '../text/language.ts';
import { inWords } from '../text/sentences.ts';
import { laboratoryWords as words } from './laboratory-words.ts';
import { gapsOf, type Run, type RunState } from './race.ts';
import { sketchName } from './race-chooser.tsx';
import { METHODS } from './race-plan.ts';

/** The runs of one sketch side by side, each with its layout as it grows. */
export function RaceCards({
  runs,
  shelf,
}: {
  readonly runs: readonly Run[];
  readonly shelf: MeshShelf;
}) {
  const sketches = [...new Set(runs.map(({ sketch }) => sketch))];
  return (
    <>
      {sketches.map((sketch) => (
        <section key={sketch.id} aria-label={sketchName(sketch)}>
          <h3>{sketchName(sketch)}</h3>
          <ul class="lab-cards">
            {runs
              .filter((run) => run.sketch === sketch)
              .map((run) => (
                <RunCard key={run.key} run={run} shelf={shelf} />
              ))}
          </ul>
        </section>
      ))}
    </>
  );
}

function RunCard({ run, shelf }: { readonly run: Run; readonly shelf: MeshShelf }) {
  const state = run.state.value;
  const name = words.method[run.method];
  return (
    <li class="lab-card" data-run={run.key} data-phase={state.phase}>
      <strong class={`look-${METHODS.indexOf(run.method)}`}>{name}</strong>
      <div class="lab-picture">
        {state.model ? <ModelPicture model={state.model} shelf={shelf} /> : null}
      </div>
      {state.phase === 'running' ? (
        <progress value={state.fraction} max={1} aria-label={name} />
      ) : null}
      <span class={state.phase === 'failed' || state.phase === 'refused' ? 'short' : 'quiet'}>
        {standing(state)}
      </span>
    </li>
  );
}

/** Where a run stands, in a few words. */
function standing({ phase, points, report, seconds, message }: RunState): string {
  if (phase === 'refused' || phase === 'failed') {
    return fillWords(words.failed, { message: inWords(message) });
  }
  if (report !== null) {
    const beams = (report.beams ?? 0) + (report.axles ?? 0);
    const gaps = gapsOf(report);
    const ended = report.buildable ? words.ended : words.endedNotBuildable;
    return fillWords(ended, { beams, gaps, seconds: formatNumber(seconds ?? 0, 1) });
  }
  const last = points.at(-1);
  const soFar = last ? fillWords(words.soFar, { beams: last.beams, gaps: last.gaps }) : '';
  return phase === 'running' ? soFar : words.phases[phase === 'waiting' ? 'waiting' : 'stopped'];
}
