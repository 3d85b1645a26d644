import { useEffect, useState } from 'preact/hooks';
import { type GalleryRow, loadGallery, loadGallerySketch } from '../gallery/gallery-index.ts';
import { usePage } from '../page-context.ts';
import { linkTo, pageFolder } from '../share/page-link.ts';
import { QrCode } from '../share/qr-code.tsx';
import { LESSONS } from './lesson-table.ts';
import { lessonWords } from './lesson-words.ts';

const words = lessonWords.teach;

interface Handout {
  readonly title: string;
  readonly url: string;
}

/** Links and codes for all lessons and models, made for printing. */
export function TeacherPage() {
  const { preferences } = usePage();
  const { preset } = preferences.value;
  const [models, setModels] = useState<readonly Handout[]>([]);
  const folder = pageFolder(location.href);
  const lessons = LESSONS.map(({ id }) => ({
    title: lessonWords.lessons[id][0],
    url: `${folder}?room=lessons&lesson=${id}`,
  }));
  useEffect(() => {
    let open = true;
    const load = async (): Promise<readonly Handout[]> => {
      const rows = await loadGallery();
      const made = await Promise.all(rows.map((row) => handoutOf(row, preset)));
      return made.flatMap((handout) => handout ?? []);
    };
    load().then(
      (made) => open && setModels(made),
      () => undefined,
    );
    return () => {
      open = false;
    };
  }, [preset]);
  return (
    <div class="teacher">
      <h3>{words.title}</h3>
      <p>{words.text}</p>
      <button type="button" class="button primary no-print" onClick={() => window.print()}>
        {words.print}
      </button>
      <h4>{words.lessons}</h4>
      <Handouts rows={lessons} />
      <h4>{words.models}</h4>
      <Handouts rows={models} />
      <p class="quiet">
        <small>{words.legal}</small>
      </p>
    </div>
  );
}

async function handoutOf(row: GalleryRow, preset: string): Promise<Handout | null> {
  const { sketch } = await loadGallerySketch(row);
  const link = await linkTo(
    { sketch: { ...sketch, name: row.title }, preset, seed: 1 },
    location.href,
  );
  return link.ok ? { title: row.title, url: link.value } : null;
}

function Handouts({ rows }: { readonly rows: readonly Handout[] }) {
  return (
    <ul class="handouts">
      {rows.map((row) => (
        <li key={row.url}>
          <QrCode text={row.url} label={row.title} />
          <a href={row.url}>{row.title}</a>
        </li>
      ))}
    </ul>
  );
}
