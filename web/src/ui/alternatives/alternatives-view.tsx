import { useEffect, useMemo, useState } from 'preact/hooks';
import type { Model } from '../../model/model.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { MeshShelf } from '../../view/drawing/drawn-part.ts';
import type { Page } from '../page.ts';
import { usePage } from '../page-context.ts';
import { settingsOf } from '../solve-settings.ts';
import { inWords } from '../text/sentences.ts';
import { alternativeWords as words } from './alternative-words.ts';
import {
  bestIn,
  candidates,
  type FigureId,
  type Figures,
  figuresOf,
  modelText,
} from './alternatives.ts';
import { CompareTable } from './compare-table.tsx';
import { type Alternative, alternativesSolver, findAlternatives } from './find-alternatives.ts';
import { ModelPicture } from './model-picture.tsx';
import './alternatives.css';

/** One model among those that are compared. */
export interface Compared {
  readonly key: string;
  readonly name: string;
  readonly model: Model;
  readonly figures: Figures;
  readonly best: ReadonlySet<FigureId>;
  /** What a click takes; null for the one on the page. */
  readonly take: Alternative | null;
}

/** Models of the drawing on the page, found one after the other; a click takes one. */
export function AlternativesView() {
  const page = usePage();
  const search = useSearch(page);
  const shelf = useMemo(() => new MeshShelf(page.catalogue), [page.catalogue]);
  const compared = comparedOf(page, search.found);
  const take = (one: Compared): void => {
    if (one.take) {
      const { preset, seed } = one.take.candidate;
      page.takeModel(one.take, { preset, seed });
      page.dialog.value = null;
      page.announce(fillWords(words.taken, { name: one.name }));
    }
  };
  return (
    <>
      <p class="quiet">{words.intro}</p>
      <ul class="alternative-grid">
        {compared.map((one) => (
          <Card key={one.key} one={one} shelf={shelf} onTake={() => take(one)} />
        ))}
      </ul>
      <Progress search={search} />
      {compared.length > 1 ? <CompareTable all={compared} /> : null}
    </>
  );
}

interface Search {
  readonly found: readonly Alternative[];
  /** Searches that are over, and how many there are. */
  readonly tried: number;
  readonly all: number;
  readonly failure: string;
  readonly stopped: boolean;
  readonly stop: () => void;
}

/** The search runs as long as the sheet is open, for what is on the page when it is opened. */
function useSearch(page: Page): Search {
  const [found, setFound] = useState<readonly Alternative[]>([]);
  const [tried, setTried] = useState(0);
  const [failure, setFailure] = useState('');
  const [stopped, setStopped] = useState(false);
  const abort = useMemo(() => new AbortController(), []);
  const all = useMemo(() => candidates(page.preferences.peek()), [page]);
  useEffect(() => {
    const preferences = page.preferences.peek();
    const shown = finishedModel(page);
    const asked = {
      sketch: page.store.sketch.peek(),
      candidates: all,
      settingsOf: ({ preset, seed }: { preset: string; seed: number }) =>
        settingsOf({ ...preferences, preset, seed }),
    };
    const watch = {
      known: shown ? modelText(shown.model) : null,
      onFound: (one: Alternative) => setFound((before) => [...before, one]),
      onTried: () => setTried((n) => n + 1),
      signal: abort.signal,
    };
    findAlternatives(alternativesSolver(), asked, watch).catch((error: unknown) =>
      setFailure(error instanceof Error ? error.message : String(error)),
    );
    return () => abort.abort();
  }, [abort, all, page]);
  const stop = () => {
    abort.abort();
    setStopped(true);
  };
  return { found, tried, all: all.length, failure, stopped, stop };
}

/** The model on the page, if it is finished and of the drawing on the page. */
function finishedModel({ shown, stale }: Page) {
  const { report, check, model } = shown.peek() ?? {};
  return report && check && model && !stale.peek() ? { model, report, check } : null;
}

function comparedOf(page: Page, found: readonly Alternative[]): Compared[] {
  const shown = finishedModel(page);
  const first = shown
    ? [
        {
          key: 'shown',
          name: words.onScreen,
          model: shown.model,
          figures: figuresOf(shown.model, shown.report, shown.check),
          take: null,
        },
      ]
    : [];
  const rows = [
    ...first,
    ...found.map((one) => ({
      key: one.candidate.id,
      name: words.names[one.candidate.id] ?? one.candidate.id,
      model: one.model,
      figures: one.figures,
      take: one,
    })),
  ];
  const best = bestIn(rows.map(({ figures }) => figures));
  return rows.map((row, i) => ({ ...row, best: best[i] ?? new Set<FigureId>() }));
}

function Card(props: {
  readonly one: Compared;
  readonly shelf: MeshShelf;
  readonly onTake: () => void;
}) {
  const { one, shelf, onTake } = props;
  const best = [...one.best].map((figure) => words.best[figure]);
  return (
    <li>
      <button
        type="button"
        class="alternative"
        disabled={one.take === null}
        aria-current={one.take === null ? 'true' : undefined}
        onClick={onTake}
      >
        <ModelPicture model={one.model} shelf={shelf} />
        <strong>{one.name}</strong>
        {one.figures.buildable ? (
          <span class="alternative-best">{best.join(', ')}</span>
        ) : (
          <span class="short">{words.notBuildable}</span>
        )}
      </button>
    </li>
  );
}

function Progress({ search }: { readonly search: Search }) {
  const { found, tried, all, failure, stopped, stop } = search;
  if (failure !== '') {
    return <p role="alert">{fillWords(words.failed, { message: inWords(failure) })}</p>;
  }
  if (tried < all && !stopped) {
    return (
      <div class="alternative-progress">
        <progress value={tried} max={all} aria-label={words.title} />
        <span role="status">{fillWords(words.searching, { n: tried + 1, all })}</span>
        <button type="button" class="button secondary small" onClick={stop}>
          {words.stop}
        </button>
      </div>
    );
  }
  const n = found.length;
  const many = n === 1 ? words.doneOne : fillWords(words.done, { n });
  return (
    <p class="quiet" role="status">
      {n === 0 ? words.none : many}
    </p>
  );
}
