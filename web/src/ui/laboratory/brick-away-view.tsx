import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import { createSolverClient } from '../../solver/client.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { MeshShelf } from '../../view/drawing/drawn-part.ts';
import { ModelPicture } from '../alternatives/model-picture.tsx';
import { usePage } from '../page-context.ts';
import { inWords } from '../text/sentences.ts';
import { type AwayStep, makeRow } from './brick-away.ts';
import { type LabSketch, labSketches } from './lab-sketches.ts';
import { laboratoryWords as words } from './laboratory-words.ts';
import { useOneJob } from './one-job.ts';
import { sketchName } from './race-chooser.tsx';

type Row = readonly AwayStep[];

/** Take one kind of beam after the other out of the brick set, and see what becomes of the model. */
export function BrickAwayView() {
  const page = usePage();
  const shelf = useMemo(() => new MeshShelf(page.catalogue), [page.catalogue]);
  const sketches = labSketches(page.store.sketch.value, page.examples.value ?? []);
  const [id, setId] = useState('cube-8');
  const sketch = sketches.find((one) => one.id === id) ?? sketches[0];
  const { row, busy, said, take, begin, stop } = useRow();
  if (sketch === undefined) {
    return null;
  }
  const last = row.at(-1);
  const next = last?.uses[0];
  return (
    <>
      <p class="quiet">{words.awayIntro}</p>
      <div class="lab-row">
        <label class="lab-select">
          <span>{words.sketch}</span>
          <select
            value={sketch.id}
            disabled={busy}
            onChange={({ currentTarget }) => setId(currentTarget.value)}
          >
            {sketches.map((one) => (
              <option key={one.id} value={one.id}>
                {sketchName(one)}
              </option>
            ))}
          </select>
        </label>
        {busy ? (
          <button type="button" class="button secondary" onClick={stop}>
            {words.stop}
          </button>
        ) : (
          <>
            <button type="button" class="button primary" onClick={() => begin(sketch)}>
              {words.awayBegin}
            </button>
            <button
              type="button"
              class="button"
              disabled={next === undefined}
              onClick={() => take(null)}
            >
              {words.awayAll}
            </button>
          </>
        )}
      </div>
      <p role={said.bad ? 'alert' : 'status'} data-testid="away-status">
        {said.text}
      </p>
      <ol class="lab-cards">
        {row.map((step, i) => (
          <StepCard
            key={step.without.join()}
            step={step}
            shelf={shelf}
            onTake={busy || i < row.length - 1 ? null : take}
          />
        ))}
      </ol>
    </>
  );
}

/** The models so far; a new one begins with another sketch. */
function useRow() {
  const page = usePage();
  const client = useMemo(() => createSolverClient(), []);
  const [row, setRow] = useState<Row>([]);
  const [said, setSaid] = useState({ text: '', bad: false });
  const sketch = useRef<LabSketch | null>(null);
  const job = useOneJob();
  useEffect(() => () => client.dispose(), [client]);
  const go = async (of: LabSketch, from: Row, part: string | null, all: boolean): Promise<void> => {
    const { signal } = job.begin();
    const without = from.at(-1)?.without ?? [];
    const ended = await makeRow(
      client,
      { sketch: of, catalogue: page.catalogue, without, part, all },
      {
        onBegin: ({ length }) =>
          setSaid({ text: fillWords(words.awayBusy, { n: length }), bad: false }),
        onStep: (step) => {
          setRow((before) => [...before, step]);
          setSaid({ text: step.uses.length > 0 ? '' : words.awayEnd, bad: false });
        },
        signal,
      },
    );
    if (!ended) {
      setSaid({ text: words.phases.stopped, bad: false });
    }
  };
  const run = (from: Row, part: string | null, all: boolean) => {
    if (sketch.current) {
      go(sketch.current, from, part, all)
        .catch((error: unknown) =>
          setSaid({
            text: fillWords(words.failed, { message: inWords(String(error)) }),
            bad: true,
          }),
        )
        .finally(job.end);
    }
  };
  return {
    row,
    busy: job.busy,
    said,
    begin: (of: LabSketch) => {
      sketch.current = of;
      setRow([]);
      run([], null, false);
    },
    /** Takes one kind away; null: the most used, again and again. */
    take: (part: string | null) =>
      run(row, part ?? row.at(-1)?.uses[0]?.part ?? null, part === null),
    stop: job.stop,
  };
}

function StepCard(props: {
  readonly step: AwayStep;
  readonly shelf: MeshShelf;
  readonly onTake: ((part: string) => void) | null;
}) {
  const { step, shelf, onTake } = props;
  const { catalogue } = usePage();
  const taken = step.without.at(-1);
  const nameOf = (part: string) => catalogue.find(part)?.name ?? part;
  const { report } = step;
  const title =
    taken === undefined ? words.awayWhole : fillWords(words.awayWithout, { part: nameOf(taken) });
  return (
    <li class="lab-card" data-without={step.without.length}>
      <strong>{title}</strong>
      <div class="lab-picture">
        {step.model ? <ModelPicture model={step.model} shelf={shelf} /> : null}
      </div>
      {report ? (
        <span class={report.buildable ? 'quiet' : 'short'}>
          {fillWords(report.buildable ? words.awayFacts : words.awayFactsBad, {
            beams: (report.beams ?? 0) + (report.axles ?? 0),
            bricks: report.bricks ?? 0,
          })}
        </span>
      ) : (
        <span class="short">{inWords(step.message)}</span>
      )}
      <ul class="lab-uses">
        {step.uses.map(({ part, count }) => (
          <li key={part}>
            {onTake ? (
              <button
                type="button"
                class="button small"
                aria-label={fillWords(words.awayTake, { part: nameOf(part) })}
                onClick={() => onTake(part)}
              >
                {count} × {nameOf(part)}
              </button>
            ) : (
              <span class="quiet">
                {count} × {nameOf(part)}
              </span>
            )}
          </li>
        ))}
      </ul>
    </li>
  );
}
