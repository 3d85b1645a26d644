import { useEffect, useMemo, useState } from 'preact/hooks';
import { PARTS_A_STEP } from '../../model/step-size.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { MeshShelf } from '../../view/drawing/drawn-part.ts';
import { Segmented } from '../controls.tsx';
import { modelComing } from '../model-coming.ts';
import { modelTitle } from '../model-title.ts';
import { NeedsModel } from '../needs-model.tsx';
import type { ShownModel } from '../page.ts';
import { usePage } from '../page-context.ts';
import { askPlan, type Book, type BookSource, makeBook } from './book.ts';
import { FilmView } from './film-view.tsx';
import { instructionWords as words } from './instruction-words.ts';
import { PartsView } from './parts-view.tsx';
import { PdfButtons } from './pdf-buttons.tsx';
import { StepsView } from './steps-view.tsx';
import './instructions.css';
import { inWords } from '../text/sentences.ts';
import { text } from '../text.ts';

type Tab = keyof typeof words.tabs;
type Loaded =
  | { readonly state: 'working' }
  | { readonly state: 'failed'; readonly message: string }
  | { readonly state: 'ready'; readonly book: Book };

/** The building instructions of the model on screen. */
export function InstructionsRoom() {
  const page = usePage();
  const shown = page.shown.value;
  if (modelComing(page)) {
    return (
      <p class="instructions-note" role="status">
        {text.rooms.solving}
      </p>
    );
  }
  return shown && shown.model.parts.length > 0 ? (
    <Instructions key={shown.json} shown={shown} title={modelTitle(page) || 'Model'} />
  ) : (
    <NeedsModel />
  );
}

/** The book of a model, made again when its steps are to be larger or smaller; the last one stays until then. */
function useBook(shown: ShownModel, title: string, most: number): Loaded {
  const { catalogue } = usePage();
  const [loaded, setLoaded] = useState<Loaded>({ state: 'working' });
  const source = useMemo(async (): Promise<BookSource> => {
    const shelf = new MeshShelf(catalogue);
    return { title, model: shown.model, shelf, plan: await askPlan(shown) };
  }, [catalogue, shown, title]);
  useEffect(() => {
    let open = true;
    source
      .then((ready) => makeBook(ready, most))
      .then(
        (book) => open && setLoaded({ state: 'ready', book }),
        (error: unknown) =>
          open &&
          setLoaded({
            state: 'failed',
            message: error instanceof Error ? error.message : String(error),
          }),
      );
    return () => {
      open = false;
    };
  }, [source, most]);
  return loaded;
}

function Instructions({ shown, title }: { readonly shown: ShownModel; readonly title: string }) {
  const { partsAStep } = usePage().preferences.value;
  const [tab, setTab] = useState<Tab>('steps');
  const loaded = useBook(shown, title, partsAStep);
  if (loaded.state === 'working') {
    return (
      <p class="instructions-note" role="status">
        {words.working}
      </p>
    );
  }
  if (loaded.state === 'failed') {
    return (
      <p class="instructions-note" role="alert">
        {fillWords(words.failed, { message: inWords(loaded.message) })}
      </p>
    );
  }
  const { book } = loaded;
  return (
    <div class="instructions">
      <div class="instructions-bar">
        <Segmented
          name="instructions-tab"
          legend={words.tabsLabel}
          choices={(['steps', 'parts', 'film'] as const).map((value) => ({
            value,
            label: words.tabs[value],
          }))}
          value={tab}
          onChange={setTab}
        />
        <StepSize />
        <PdfButtons book={book} />
      </div>
      {book.plan.assemblable ? null : (
        <p class="instructions-warning" role="alert">
          {words.stuck}
        </p>
      )}
      {/* Where a reader is means nothing among other steps. */}
      {tab === 'steps' ? <StepsView key={book.most} book={book} json={shown.json} /> : null}
      {tab === 'parts' ? <PartsView book={book} /> : null}
      {tab === 'film' ? <FilmView book={book} /> : null}
    </div>
  );
}

/** From one part a step, for a beginner, to six. */
function StepSize() {
  const { preferences } = usePage();
  const { partsAStep } = preferences.value;
  return (
    <label class="step-size">
      <span>{words.partsAStep}</span>
      <input
        type="range"
        min={PARTS_A_STEP.least}
        max={PARTS_A_STEP.most}
        step={1}
        value={partsAStep}
        aria-valuetext={fillWords(words.partsAStepValue, { n: partsAStep })}
        onInput={(event) => {
          const chosen = Number(event.currentTarget.value);
          preferences.value = { ...preferences.peek(), partsAStep: chosen };
        }}
      />
      <output>{partsAStep}</output>
    </label>
  );
}
