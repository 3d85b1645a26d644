import { useMemo, useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { MeshShelf } from '../../view/drawing/drawn-part.ts';
import type { Figures } from '../alternatives/alternatives.ts';
import {
  type Alternative,
  alternativesSolver,
  searchOne,
} from '../alternatives/find-alternatives.ts';
import { ModelPicture } from '../alternatives/model-picture.tsx';
import { NeedsModel } from '../needs-model.tsx';
import { usePage } from '../page-context.ts';
import { settingsOf } from '../solve-settings.ts';
import { formatNumber } from '../text/language.ts';
import { inWords } from '../text/sentences.ts';
import { laboratoryWords as words } from './laboratory-words.ts';
import { useOneJob } from './one-job.ts';
import {
  MOST_TURNS,
  NO_TURNS,
  PROPOSALS,
  type ProposalId,
  proposalCandidates,
  type Turns,
  WEIGHED,
  type Weighed,
  weightsText,
  withWeights,
} from './proposals.ts';

type Found = Readonly<Partial<Record<ProposalId, Alternative | null>>>;

/** Weights as sliders; four proposals for the drawing side by side, and a click takes one. */
export function ProposalsView({ close }: { readonly close: () => void }) {
  const page = usePage();
  const shelf = useMemo(() => new MeshShelf(page.catalogue), [page.catalogue]);
  const [turns, setTurns] = useState<Turns>(NO_TURNS);
  const { found, busy, failure, find, stop } = useProposals();
  if (page.store.sketch.value.lines.length === 0) {
    return <NeedsModel />;
  }
  const take = (id: ProposalId, one: Alternative): void => {
    const { preset, seed } = one.candidate;
    const advanced = withWeights(page.preferences.peek().advanced, weightsText(id, found.turns));
    page.takeModel(one, { preset, seed, advanced });
    page.announce(fillWords(words.taken, { name: words.proposals[id] }));
    close();
  };
  return (
    <>
      <p class="quiet">{words.weightsIntro}</p>
      <div class="lab-sliders">
        {WEIGHED.map((term) => (
          <Slider
            key={term}
            term={term}
            value={turns[term]}
            onChange={(value) => setTurns({ ...turns, [term]: value })}
          />
        ))}
      </div>
      <div class="lab-row">
        {busy ? (
          <button type="button" class="button secondary" onClick={stop}>
            {words.stop}
          </button>
        ) : (
          <button type="button" class="button primary" onClick={() => find(turns)}>
            {words.propose}
          </button>
        )}
        <button type="button" class="button" onClick={() => setTurns(NO_TURNS)}>
          {words.usualWeights}
        </button>
      </div>
      <p role={failure === '' ? 'status' : 'alert'} class="quiet" data-testid="proposals-status">
        {failure || (busy ? words.proposing : '')}
      </p>
      <ul class="alternative-grid">
        {PROPOSALS.map((id) => (
          <ProposalCard key={id} id={id} found={found.models} shelf={shelf} onTake={take} />
        ))}
      </ul>
    </>
  );
}

/** Four searches, one after the other; they end with the view. */
function useProposals() {
  const page = usePage();
  const [found, setFound] = useState<{ readonly models: Found; readonly turns: Turns }>({
    models: {},
    turns: NO_TURNS,
  });
  const [failure, setFailure] = useState('');
  const job = useOneJob();
  const findAll = async (turns: Turns): Promise<void> => {
    const { signal } = job.begin();
    const preferences = page.preferences.peek();
    const candidates = proposalCandidates(preferences.seed);
    const asked = {
      sketch: page.store.sketch.peek(),
      candidates,
      settingsOf: ({ id, preset, seed }: (typeof candidates)[number]) => {
        const advanced = withWeights(preferences.advanced, weightsText(id, turns));
        return settingsOf({ ...preferences, preset, seed, advanced });
      },
    };
    setFound({ models: {}, turns });
    for (const candidate of candidates) {
      const one = signal.aborted
        ? null
        : await searchOne(alternativesSolver(), asked, candidate, signal);
      if (signal.aborted) {
        return;
      }
      setFound(({ models }) => ({ models: { ...models, [candidate.id]: one }, turns }));
    }
  };
  const find = (turns: Turns) => {
    setFailure('');
    findAll(turns)
      .catch((error: unknown) =>
        setFailure(fillWords(words.failed, { message: inWords(String(error)) })),
      )
      .finally(job.end);
  };
  return { found, busy: job.busy, failure, find, stop: job.stop };
}

function Slider(props: {
  readonly term: Weighed;
  readonly value: number;
  readonly onChange: (value: number) => void;
}) {
  const { term, value, onChange } = props;
  const times = fillWords(words.times, { n: formatNumber(2 ** value, value < 0 ? -value : 0) });
  return (
    <label class="lab-slider">
      <span>{words.weighed[term]}</span>
      <span class="quiet">{times}</span>
      <input
        type="range"
        min={-MOST_TURNS}
        max={MOST_TURNS}
        step={1}
        value={value}
        aria-valuetext={times}
        onInput={(event) => onChange(event.currentTarget.valueAsNumber)}
      />
    </label>
  );
}

function ProposalCard(props: {
  readonly id: ProposalId;
  readonly found: Found;
  readonly shelf: MeshShelf;
  readonly onTake: (id: ProposalId, one: Alternative) => void;
}) {
  const { id, found, shelf, onTake } = props;
  const one = found[id];
  return (
    <li>
      <button
        type="button"
        class="alternative"
        disabled={!one}
        onClick={() => one && onTake(id, one)}
      >
        <div class="lab-picture">
          {one ? <ModelPicture model={one.model} shelf={shelf} /> : null}
        </div>
        <strong>{words.proposals[id]}</strong>
        <span class="quiet">{words.proposalText[id]}</span>
        {one ? <span>{figuresText(one.figures)}</span> : null}
        {one === null ? <span class="short">{words.noProposal}</span> : null}
        {one && !one.figures.buildable ? <span class="short">{words.notBuildable}</span> : null}
      </button>
    </li>
  );
}

function figuresText({ bricks, deviation, freedoms, mass }: Figures): string {
  return fillWords(words.proposalFigures, {
    bricks: bricks ?? 0,
    mass: formatNumber(mass ?? 0),
    deviation: formatNumber(deviation ?? 0, 2),
    freedoms: freedoms ?? 0,
  });
}
