import { useEffect, useRef, useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import {
  makeRandom,
  randomState,
  stackAt,
  TOY,
  troubleAt,
  troubleOf,
  tryMove,
} from './annealing-model.ts';
import { lessonWords } from './lesson-words.ts';
import { Praise } from './praise.tsx';

const words = lessonWords.annealing;
const HOT = 15;
const TRIES_PER_TICK = 120;
const TICK_MS = 60;
const COOLING = 0.98;
const COLOURS = ['#4477aa', '#ee6677', '#228833', '#ccbb44'] as const;
const MAX_CHART = 300;

interface Run {
  readonly layers: readonly number[];
  readonly tries: number;
  readonly kept: number;
  readonly chart: readonly number[];
}

/** The search at work on a toy, with the temperature in the hand of whoever watches. */
export function AnnealingLesson() {
  const [seed, setSeed] = useState(7);
  const random = useRef(makeRandom(seed));
  const [run, setRun] = useState<Run>(() => begin(random.current));
  const [temperature, setTemperature] = useState(HOT);
  const [cooling, setCooling] = useState(false);
  const [running, setRunning] = useState(false);
  const trouble = troubleOf(run.layers);
  useEffect(() => {
    if (!running || trouble === 0) {
      return undefined;
    }
    const timer = setInterval(() => {
      setRun((old) => advance(old, temperature, random.current));
      if (cooling) {
        setTemperature((value) => (value < 0.05 ? 0 : value * COOLING));
      }
    }, TICK_MS);
    return () => clearInterval(timer);
  }, [running, trouble === 0, temperature, cooling]);
  const restart = () => {
    const next = seed + 1;
    random.current = makeRandom(next);
    setSeed(next);
    setRun(begin(random.current));
  };
  return (
    <>
      <ToyFigure layers={run.layers} />
      <div class="lesson-row">
        <button type="button" class="button primary" onClick={() => setRunning(!running)}>
          {running ? words.pause : words.run}
        </button>
        <label>
          {words.temperature}{' '}
          <input
            type="range"
            min={0}
            max={HOT}
            step={0.05}
            value={temperature}
            onInput={(event) => setTemperature(Number(event.currentTarget.value))}
          />{' '}
          {temperature.toFixed(2)}
        </label>
        <label>
          <input
            type="checkbox"
            checked={cooling}
            onChange={(event) => setCooling(event.currentTarget.checked)}
          />{' '}
          {words.cool}
        </label>
        <button type="button" class="button" onClick={restart}>
          {lessonWords.reset}
        </button>
      </div>
      <p>
        <strong data-testid="trouble">{fillWords(words.cost, { n: trouble })}</strong> ·{' '}
        {fillWords(words.steps, { n: run.tries, kept: run.kept })}
      </p>
      <Chart values={run.chart} />
      <Praise when={trouble === 0} words={words.solved} />
    </>
  );
}

function begin(random: () => number): Run {
  const layers = randomState(random);
  return { layers, tries: 0, kept: 0, chart: [troubleOf(layers)] };
}

function advance(run: Run, temperature: number, random: () => number): Run {
  const layers = [...run.layers];
  let { tries, kept } = run;
  for (let i = 0; i < TRIES_PER_TICK && troubleOf(layers) > 0; i++) {
    tries += 1;
    kept += tryMove(layers, temperature, random) ? 1 : 0;
  }
  const chart = [...run.chart, troubleOf(layers)].slice(-MAX_CHART);
  return { layers, tries, kept, chart };
}

function ToyFigure({ layers }: { readonly layers: readonly number[] }) {
  const { rows, columns } = TOY;
  const colour = (beam: number) => COLOURS[layers[beam] ?? 0] ?? COLOURS[0];
  const bars = [];
  const marks = [];
  for (let row = 0; row < rows; row++) {
    const seam = 3 + (row % 2);
    bars.push(
      <path key={`l${row}`} d={`M0 ${row}H${seam}`} stroke={colour(row)} class="toy-beam" />,
      <path
        key={`r${row}`}
        d={`M${seam} ${row + 0.16}H${columns - 1}`}
        stroke={colour(rows + row)}
        class="toy-beam"
      />,
    );
    for (let column = 0; column < columns; column++) {
      if (troubleAt(layers, row, column) > 0) {
        const size = 0.2 + 0.04 * stackAt(row, column).length;
        marks.push(
          <circle key={`${row}/${column}`} class="toy-trouble" cx={column} cy={row} r={size} />,
        );
      }
    }
  }
  return (
    <svg class="lesson-figure" viewBox="-1 -1 9 9" role="img" aria-label={words.figure}>
      {bars}
      {Array.from({ length: columns }, (_, column) => (
        <path
          key={column}
          d={`M${column} 0V${rows - 1}`}
          stroke={colour(2 * rows + column)}
          class="toy-beam"
        />
      ))}
      {marks}
    </svg>
  );
}

function Chart({ values }: { readonly values: readonly number[] }) {
  const top = Math.max(1, ...values);
  const points = values
    .map(
      (value, i) => `${((i / MAX_CHART) * 300).toFixed(1)},${(60 - (value / top) * 56).toFixed(1)}`,
    )
    .join(' ');
  return (
    <svg class="lesson-chart" viewBox="0 0 300 62" role="img" aria-label={words.chart}>
      <polyline points={points} />
    </svg>
  );
}
