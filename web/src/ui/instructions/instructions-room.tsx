import { useEffect, useMemo, useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { MeshShelf } from '../../view/drawing/drawn-part.ts';
import { Segmented } from '../controls.tsx';
import { modelComing } from '../model-coming.ts';
import { NeedsModel } from '../needs-model.tsx';
import type { ShownModel } from '../page.ts';
import { usePage } from '../page-context.ts';
import type { Book } from './book.ts';
import { makeBook } from './book.ts';
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
    <Instructions key={shown.json} shown={shown} title={page.store.sketch.value.name || 'Model'} />
  ) : (
    <NeedsModel />
  );
}

function Instructions({ shown, title }: { readonly shown: ShownModel; readonly title: string }) {
  const { catalogue } = usePage();
  const shelf = useMemo(() => new MeshShelf(catalogue), [catalogue]);
  const [loaded, setLoaded] = useState<Loaded>({ state: 'working' });
  const [tab, setTab] = useState<Tab>('steps');
  useEffect(() => {
    let open = true;
    makeBook(title, shown, shelf).then(
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
  }, [shown, shelf, title]);
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
        <PdfButtons book={book} />
      </div>
      {book.plan.assemblable ? null : (
        <p class="instructions-warning" role="alert">
          {words.stuck}
        </p>
      )}
      {tab === 'steps' ? <StepsView book={book} json={shown.json} /> : null}
      {tab === 'parts' ? <PartsView book={book} /> : null}
      {tab === 'film' ? <FilmView book={book} /> : null}
    </div>
  );
}
