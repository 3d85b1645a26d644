import { useEffect, useRef, useState } from 'preact/hooks';
import type { PlacedPart } from '../../model/model.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { StillRenderer } from '../../view/still/still-renderer.ts';
import { usePage } from '../page-context.ts';
import { solveSketch } from '../share/solved-parts.ts';
import { formatNumber } from '../text/language.ts';
import { fetchJson, type GalleryRow, galleryFile, loadGallerySketch } from './gallery-index.ts';
import { galleryWords as words } from './gallery-words.ts';
import { type GearTrain, placeTrain, readGearTrain } from './gear-train.ts';

const SIZE = { width: 960, height: 600 } as const;
const SECONDS_A_TURN = 4;

interface Geared {
  readonly frame: readonly PlacedPart[];
  readonly train: GearTrain;
}

/** A gallery model whose gears turn: by a crank, or by themselves. */
export function GearView({
  row,
  onBack,
}: {
  readonly row: GalleryRow;
  readonly onBack: () => void;
}) {
  const { catalogue, preferences } = usePage();
  const [geared, setGeared] = useState<Geared | null>(null);
  const [failure, setFailure] = useState('');
  const { preset } = preferences.value;
  useEffect(() => {
    const load = async (): Promise<Geared> => {
      const [{ sketch }, gears] = await Promise.all([
        loadGallerySketch(row),
        fetchJson(galleryFile(row.gears ?? '')),
      ]);
      const train = readGearTrain(gears, catalogue);
      if (!train.ok) {
        throw new Error(train.message);
      }
      const { parts } = await solveSketch(sketch, { preset, seed: 1 });
      return { frame: parts, train: train.value };
    };
    load().then(setGeared, (error: unknown) =>
      setFailure(fillWords(words.failed, { message: String(error) })),
    );
  }, [row, catalogue, preset]);
  return (
    <div class="gear-view">
      <button type="button" class="button plain" onClick={onBack}>
        {words.back}
      </button>
      <h3>{row.title}</h3>
      <p class="quiet">{row.text}</p>
      {failure ? <p role="alert">{failure}</p> : null}
      {geared ? <Turning geared={geared} /> : failure ? null : <p role="status">{words.working}</p>}
    </div>
  );
}

function Turning({ geared }: { readonly geared: Geared }) {
  const { catalogue } = usePage();
  const { train, frame } = geared;
  const host = useRef<HTMLDivElement>(null);
  const renderer = useRef<StillRenderer | null>(null);
  const [turns, setTurns] = useState(0);
  const [auto, setAuto] = useState(false);
  useEffect(() => {
    const made = new StillRenderer(catalogue);
    renderer.current = made;
    host.current?.append(made.canvas);
    return () => {
      made.canvas.remove();
      made.dispose();
    };
  }, [catalogue]);
  useEffect(() => {
    const gears = placeTrain(train, turns * 2 * Math.PI, catalogue);
    renderer.current?.draw({
      ...SIZE,
      parts: [...frame, ...gears],
      direction: [-0.35, -0.8, 0.5],
      backdrop: 'studio',
    });
  }, [turns, train, frame, catalogue]);
  useEffect(() => {
    if (!auto) {
      return undefined;
    }
    let last = performance.now();
    let request = requestAnimationFrame(function next(now) {
      const moved = (now - last) / 1000 / SECONDS_A_TURN;
      last = now;
      setTurns((value) => value + moved);
      request = requestAnimationFrame(next);
    });
    return () => cancelAnimationFrame(request);
  }, [auto]);
  return (
    <>
      <div class="gear-host" ref={host} role="img" aria-label={words.gearsLabel} />
      <div class="gear-bar">
        <label>
          {words.crank}
          <input
            type="range"
            min={0}
            max={15}
            step={0.01}
            value={turns % 15}
            onInput={(event) => {
              setAuto(false);
              setTurns(Number(event.currentTarget.value));
            }}
          />
        </label>
        <label>
          <input
            type="checkbox"
            checked={auto}
            onChange={(event) => setAuto(event.currentTarget.checked)}
          />
          {words.auto}
        </label>
      </div>
      <Ratio train={train} turns={turns} />
    </>
  );
}

function Ratio({ train, turns }: { readonly train: GearTrain; readonly turns: number }) {
  const last = Math.abs(train.speeds.at(-1) ?? 1);
  const sentence =
    last < 1
      ? fillWords(words.ratio, { n: formatNumber(1 / last) })
      : fillWords(words.ratioUp, { n: formatNumber(last) });
  return (
    <>
      <p data-testid="ratio">{sentence}</p>
      <ol class="gear-shafts">
        {train.shafts.map((shaft, i) => (
          <li key={shaft.at.join()} data-turns={(turns * (train.speeds[i] ?? 0)).toFixed(4)}>
            {fillWords(words.shaft, { n: i + 1 })}:{' '}
            {fillWords(words.turns, { n: formatNumber(turns * (train.speeds[i] ?? 0), 2) })}
          </li>
        ))}
      </ol>
    </>
  );
}
