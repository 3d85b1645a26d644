import { useEffect, useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { usePage } from '../page-context.ts';
import { copyText } from '../share/copy-text.ts';
import { linkTo } from '../share/page-link.ts';
import { formatNumber } from '../text/language.ts';
import {
  type GalleryRow,
  loadGallery,
  loadGallerySketch,
  loadMade,
  thumbnailOf,
} from './gallery-index.ts';
import { galleryWords as words } from './gallery-words.ts';
import { GearView } from './gear-view.tsx';
import { JointView } from './joint-view.tsx';
import './gallery.css';

const SHELVES = [
  { title: words.models, holds: (row: GalleryRow) => !row.firstStep },
  { title: words.firstSteps, holds: (row: GalleryRow) => row.firstStep },
];

/** The paper's models and others as our own drawings: large ones, and small ones to begin with. */
export function GalleryRoom() {
  const page = usePage();
  const [rows, setRows] = useState<readonly GalleryRow[] | null>(null);
  const [said, setSaid] = useState({ text: '', bad: false });
  const [turning, setTurning] = useState<GalleryRow | null>(null);
  const failed = (error: unknown) =>
    setSaid({ text: fillWords(words.failed, { message: String(error) }), bad: true });
  useEffect(() => {
    loadGallery().then(setRows, failed);
  }, []);
  const open = async (row: GalleryRow): Promise<void> => {
    const [example, made] = await Promise.all([
      loadGallerySketch(row),
      // Without it the model is searched for.
      row.made ? loadMade(row).catch(() => null) : null,
    ]);
    page.openExample(example, made);
    page.openRoom(null);
  };
  const copy = async (row: GalleryRow): Promise<void> => {
    const { sketch } = await loadGallerySketch(row);
    const { preset } = page.preferences.value;
    const link = await linkTo(
      { sketch: { ...sketch, name: row.title }, preset, seed: 1 },
      location.href,
    );
    if (!link.ok) {
      throw new Error(link.message);
    }
    await copyText(link.value);
    setSaid({ text: fillWords(words.copied, { name: row.title }), bad: false });
  };
  if (turning) {
    const back = () => setTurning(null);
    return turning.gears ? (
      <GearView row={turning} onBack={back} />
    ) : (
      <JointView row={turning} onBack={back} />
    );
  }
  return (
    <div class="gallery">
      <p class="quiet">{words.intro}</p>
      <p role={said.bad ? 'alert' : 'status'}>{said.text}</p>
      {SHELVES.map(({ title, holds }) => (
        <section key={title}>
          <h3>{title}</h3>
          <ul class="gallery-grid">
            {rows?.filter(holds).map((row) => (
              <GalleryCard
                key={row.id}
                row={row}
                onOpen={() => {
                  open(row).catch(failed);
                }}
                onCopy={() => {
                  copy(row).catch(failed);
                }}
                onTurn={row.gears || row.moves ? () => setTurning(row) : null}
              />
            ))}
          </ul>
        </section>
      ))}
    </div>
  );
}

function GalleryCard(props: {
  readonly row: GalleryRow;
  readonly onOpen: () => void;
  readonly onCopy: () => void;
  readonly onTurn: (() => void) | null;
}) {
  const { row, onOpen, onCopy, onTurn } = props;
  return (
    <li class="gallery-card" data-model={row.id}>
      <button type="button" class="gallery-open" onClick={onOpen}>
        <img src={thumbnailOf(row)} alt="" width={320} height={240} loading="lazy" />
        <strong>{row.title}</strong>
        <span class="quiet">{row.text}</span>
      </button>
      <p class="gallery-facts">
        <span>
          {fillWords(words.facts, {
            beams: row.beams,
            bricks: row.bricks,
            mass: formatNumber(row.mass),
          })}
        </span>
        {row.moves ? <span class="gallery-badge">{words.moves}</span> : null}
      </p>
      <div class="gallery-buttons">
        {onTurn ? (
          <button type="button" class="button" onClick={onTurn}>
            {row.gears ? words.turn : words.move}
          </button>
        ) : null}
        <button type="button" class="button plain" onClick={onCopy}>
          {words.copy}
        </button>
      </div>
    </li>
  );
}
