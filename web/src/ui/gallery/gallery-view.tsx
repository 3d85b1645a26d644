import type { ComponentChildren } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import type { Catalogue } from '../../model/catalogue.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { usePage } from '../page-context.ts';
import { inWords } from '../text/sentences.ts';
import type { GalleryRow } from './gallery-index.ts';
import { galleryWords as words } from './gallery-words.ts';

type Loaded<T> =
  | { readonly state: 'waiting' }
  | { readonly state: 'done'; readonly value: T }
  | { readonly state: 'failed'; readonly message: string };

/** What a promise gives, asked for again when one of `inputs` changes. */
function useLoaded<T>(load: () => Promise<T>, inputs: readonly unknown[]): Loaded<T> {
  const [loaded, setLoaded] = useState<Loaded<T>>({ state: 'waiting' });
  useEffect(() => {
    let wanted = true;
    load().then(
      (value) => wanted && setLoaded({ state: 'done', value }),
      (error: unknown) => {
        const message = error instanceof Error ? error.message : String(error);
        return wanted && setLoaded({ state: 'failed', message });
      },
    );
    return () => {
      wanted = false;
    };
  }, inputs);
  return loaded;
}

/** What every view of one gallery model is given. */
export interface GalleryViewProps {
  readonly row: GalleryRow;
  readonly onBack: () => void;
}

/**
 * One model of the gallery by itself: what it is, and below that what can be moved.
 * @param load makes what `children` show; asked again for another row or preset.
 */
export function GalleryView<T>(
  props: GalleryViewProps & {
    readonly load: (row: GalleryRow, preset: string, catalogue: Catalogue) => Promise<T>;
    readonly children: (value: T) => ComponentChildren;
  },
) {
  const { row, onBack, load, children } = props;
  const { catalogue, preferences } = usePage();
  const { preset } = preferences.value;
  const loaded = useLoaded(() => load(row, preset, catalogue), [row, preset, catalogue]);
  return (
    <div class="gallery-view" data-model={row.id}>
      <button type="button" class="button plain" onClick={onBack}>
        {words.back}
      </button>
      <h3>{row.title}</h3>
      <p class="quiet">{row.text}</p>
      {loaded.state === 'waiting' ? <p role="status">{words.working}</p> : null}
      {loaded.state === 'failed' ? (
        <p role="alert">{fillWords(words.failed, { message: inWords(loaded.message) })}</p>
      ) : null}
      {loaded.state === 'done' ? children(loaded.value) : null}
    </div>
  );
}
