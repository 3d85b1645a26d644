import { useEffect, useMemo, useState } from 'preact/hooks';
import type { Catalogue } from '../../model/catalogue.ts';
import type { PlacedPart } from '../../model/model.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { usePage } from '../page-context.ts';
import { solveSketch } from '../share/solved-parts.ts';
import { formatNumber } from '../text/language.ts';
import { fetchJson, type GalleryRow, galleryFile, loadGallerySketch } from './gallery-index.ts';
import { GalleryView, type GalleryViewProps } from './gallery-view.tsx';
import { galleryWords as words } from './gallery-words.ts';
import { type GearTrain, placeTrain, readGearTrain, withTrain } from './gear-train.ts';
import { MovingPicture } from './moving-picture.tsx';

const SECONDS_A_TURN = 4;

interface Geared {
  readonly title: string;
  readonly frame: readonly PlacedPart[];
  readonly train: GearTrain;
  /** The model file of frame and gears together. */
  readonly json: string;
}

/** A gallery model whose gears turn: by a crank, or by themselves. */
export function GearView(props: GalleryViewProps) {
  return (
    <GalleryView {...props} load={load}>
      {(geared) => <Turning geared={geared} />}
    </GalleryView>
  );
}

async function load(row: GalleryRow, preset: string, catalogue: Catalogue): Promise<Geared> {
  const [{ sketch }, gears] = await Promise.all([
    loadGallerySketch(row),
    fetchJson(galleryFile(row.gears ?? '')),
  ]);
  const train = readGearTrain(gears, catalogue);
  if (!train.ok) {
    throw new Error(train.message);
  }
  const { parts, json } = await solveSketch(sketch, { preset, seed: 1 });
  return {
    title: row.title,
    frame: parts,
    train: train.value,
    json: withTrain(json, train.value, catalogue),
  };
}

function Turning({ geared }: { readonly geared: Geared }) {
  const { catalogue, openFile, openRoom } = usePage();
  const { train, frame } = geared;
  const [turns, setTurns] = useState(0);
  const [auto, setAuto] = useState(false);
  const parts = useMemo(
    () => [...frame, ...placeTrain(train, turns * 2 * Math.PI, catalogue)],
    [frame, train, turns, catalogue],
  );
  useTurning(auto, setTurns);
  const openWhole = () => {
    openRoom(null);
    openFile(new File([geared.json], `${geared.title}.model.json`, { type: 'application/json' }));
  };
  return (
    <>
      <MovingPicture parts={parts} label={words.gearsLabel} />
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
        <button type="button" class="button" onClick={openWhole}>
          {words.openWhole}
        </button>
      </div>
      <Ratio train={train} turns={turns} />
    </>
  );
}

function useTurning(auto: boolean, setTurns: (change: (before: number) => number) => void): void {
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
  }, [auto, setTurns]);
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
