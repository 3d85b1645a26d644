import { useMemo, useState } from 'preact/hooks';
import { sharedState } from '../../share/shared-state.ts';
import { createLabClient } from '../../solver/lab/lab-client.ts';
import { workersFor } from '../../solver/solver-pool.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { MeshShelf } from '../../view/drawing/drawn-part.ts';
import { Icon } from '../icon.tsx';
import type { Page } from '../page.ts';
import { usePage } from '../page-context.ts';
import { copyText } from '../share/copy-text.ts';
import { linkTo } from '../share/page-link.ts';
import { saveFile } from '../share/save-file.ts';
import { LAB_KEYS, setInAddress, textInAddress } from './lab-address.ts';
import { type LabSketch, labSketches } from './lab-sketches.ts';
import { laboratoryWords as words } from './laboratory-words.ts';
import { useOneJob } from './one-job.ts';
import { newRun, type Run, race } from './race.ts';
import { RaceCards } from './race-cards.tsx';
import { LengthChart, TimeChart } from './race-charts.tsx';
import { RaceChooser } from './race-chooser.tsx';
import { FIRST_PLAN, type RacePlan, readPlan, settingsOfRun, writePlan } from './race-plan.ts';
import { csvOf, resultsOf } from './race-results.ts';
import { RaceTable } from './race-table.tsx';

/** What is racing, or has. */
interface Started {
  readonly plan: RacePlan;
  readonly runs: readonly Run[];
  readonly stop: AbortController;
}

/** Choose sketches and methods, watch them race, take the results along. */
export function RaceView() {
  const page = usePage();
  const { plan, setPlan } = usePlan();
  const { started, racing, start, stop } = useRace();
  const sketches = labSketches(page.store.sketch.value, page.examples.value ?? []);
  const shelf = useMemo(() => new MeshShelf(page.catalogue), [page.catalogue]);
  const chosen = sketches.filter(({ id }) => plan.sketches.includes(id));
  const count = chosen.length * plan.methods.length;
  return (
    <>
      <p class="quiet">{words.raceIntro}</p>
      <RaceChooser plan={plan} sketches={sketches} disabled={racing} onChange={setPlan} />
      <div class="lab-row">
        {racing ? (
          <button type="button" class="button secondary" onClick={stop}>
            <Icon name="stop" />
            <span>{words.stop}</span>
          </button>
        ) : (
          <button
            type="button"
            class="button primary"
            disabled={count === 0}
            onClick={() => start(plan, chosen)}
          >
            <Icon name="play" />
            <span>{words.start}</span>
          </button>
        )}
        <RaceStatus count={count} started={started} racing={racing} />
      </div>
      {started ? <Races started={started} shelf={shelf} /> : null}
    </>
  );
}

/** The plan, kept in the address so that the address gives it again. */
function usePlan() {
  const [plan, set] = useState<RacePlan>(
    () => readPlan(textInAddress(LAB_KEYS.race)) ?? FIRST_PLAN,
  );
  const setPlan = (next: RacePlan) => {
    set(next);
    setInAddress(LAB_KEYS.race, writePlan(next));
  };
  return { plan, setPlan };
}

/** One race at a time; it ends with the room. */
function useRace() {
  const [started, setStarted] = useState<Started | null>(null);
  const job = useOneJob();
  const start = (plan: RacePlan, sketches: readonly LabSketch[]) => {
    const controller = job.begin();
    const runs = sketches.flatMap((sketch) =>
      plan.methods.map((method) => newRun(sketch, method, settingsOfRun(plan, method))),
    );
    setStarted({ plan, runs, stop: controller });
    const lanes = workersFor(navigator.hardwareConcurrency + 1);
    const options = { lanes, createClient: createLabClient, now: () => performance.now() };
    void race(runs, options, controller.signal).then(job.end);
  };
  return { started, racing: job.busy, start, stop: job.stop };
}

function RaceStatus(props: {
  readonly count: number;
  readonly started: Started | null;
  readonly racing: boolean;
}) {
  const { count, started, racing } = props;
  const runs = started?.runs ?? [];
  const ended = runs.filter(({ state }) => !['waiting', 'running'].includes(state.value.phase));
  const n = racing ? runs.length : count;
  const choose = count === 0 ? words.chooseSome : fillWords(words.toRun, { n });
  const under = fillWords(words.underWay, { n: ended.length, all: runs.length });
  return (
    <p role="status" class="quiet" data-testid="race-status">
      {racing ? under : started ? fillWords(words.raceOver, { n: ended.length }) : choose}
    </p>
  );
}

function Races({ started, shelf }: { readonly started: Started; readonly shelf: MeshShelf }) {
  const { runs, plan } = started;
  const results = resultsOf(runs);
  return (
    <>
      <RaceCards runs={runs} shelf={shelf} />
      <TimeChart runs={runs} />
      <LengthChart results={results} />
      {results.length > 0 ? (
        <section>
          <h3>{words.results}</h3>
          <RaceTable results={results} sketches={[...new Set(runs.map(({ sketch }) => sketch))]} />
          <TakeAlong plan={plan} csv={() => csvOf(results)} />
        </section>
      ) : null}
    </>
  );
}

function TakeAlong(props: { readonly plan: RacePlan; readonly csv: () => string }) {
  const page = usePage();
  const [said, setSaid] = useState({ text: '', bad: false });
  const copy = async (): Promise<void> => {
    await copyText(await linkOfRace(page, props.plan));
    setSaid({ text: words.copied, bad: false });
  };
  return (
    <>
      <div class="lab-row">
        <button
          type="button"
          class="button"
          onClick={() => saveFile('laboratory.csv', new Blob([props.csv()], { type: 'text/csv' }))}
        >
          {words.saveCsv}
        </button>
        <button
          type="button"
          class="button"
          onClick={() => {
            copy().catch((error: unknown) =>
              setSaid({ text: fillWords(words.failed, { message: String(error) }), bad: true }),
            );
          }}
        >
          {words.copyLink}
        </button>
      </div>
      <p role={said.bad ? 'alert' : 'status'}>{said.text}</p>
      <p class="quiet">{words.sameEverywhere}</p>
    </>
  );
}

/** The address that opens the laboratory with these choices; it holds the drawing where that races too. */
async function linkOfRace(page: Page, plan: RacePlan): Promise<string> {
  const own = plan.sketches.some((id) => id === 'mine' || id.startsWith('mine-'));
  const url = new URL('./', location.href);
  url.searchParams.set('room', 'laboratory');
  url.searchParams.set(LAB_KEYS.race, writePlan(plan));
  if (own) {
    const link = await linkTo(
      sharedState(page.store.sketch.peek(), page.preferences.peek()),
      location.href,
    );
    if (!link.ok) {
      throw new Error(link.message);
    }
    url.hash = new URL(link.value).hash;
  }
  return url.href;
}
