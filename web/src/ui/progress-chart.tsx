import { useState } from 'preact/hooks';
import { fillWords } from '../tools/tool-words.ts';
import type { ChartPoint } from './page.ts';
import { formatNumber } from './text/language.ts';
import { text } from './text.ts';

const WIDTH = 288;
const TALL = 72;
const LOW = 56;
const PAD = 3;

/** One curve of the chart: its name, its colour's class, its values. */
interface Curve {
  readonly name: string;
  readonly look: string;
  readonly value: (point: ChartPoint) => number;
}

const ABOVE: readonly Curve[] = [
  { name: text.solve.objective, look: 'objective', value: (p) => p.objective },
  { name: text.solve.temperature, look: 'temperature', value: (p) => p.temperature },
];

/** So many terms have a look of their own. */
const TERM_LOOKS = 6;

/** The terms that the objective of these points is made of, the largest first. */
export function termCurves(points: readonly ChartPoint[]): readonly Curve[] {
  const names = new Set(points.flatMap((point) => Object.keys(point.terms)));
  const value = (name: string) => (point: ChartPoint) => point.terms[name] ?? 0;
  const most = (name: string) => Math.max(...points.map(value(name)));
  return [...names]
    .filter((name) => most(name) > 0)
    .sort((a, b) => most(b) - most(a) || (a < b ? -1 : 1))
    .slice(0, TERM_LOOKS)
    .map((name, i) => ({
      name: (text.solve.term as Readonly<Record<string, string>>)[name] ?? name,
      look: `term term-${i + 1}`,
      value: value(name),
    }));
}

/**
 * A curve in a box: steps of the search to the right, low values at the bottom.
 * @param span lowest and highest value of the box.
 */
export function chartPath(
  points: readonly ChartPoint[],
  value: (point: ChartPoint) => number,
  span: readonly [number, number],
  height: number,
): string {
  const [y0, y1] = span;
  const py = (y: number) => height - PAD - ((y - y0) / (y1 - y0 || 1)) * (height - 2 * PAD);
  return points
    .map((point, i) => {
      const at = `${placeOf(points, point).toFixed(1)} ${py(value(point)).toFixed(1)}`;
      return `${i === 0 ? 'M' : 'L'}${at}`;
    })
    .join('');
}

function placeOf(points: readonly ChartPoint[], point: ChartPoint): number {
  const first = points[0]?.iterations ?? 0;
  const last = points.at(-1)?.iterations ?? 1;
  return PAD + ((point.iterations - first) / (last - first || 1)) * (WIDTH - 2 * PAD);
}

function spanOf(
  points: readonly ChartPoint[],
  values: readonly ((point: ChartPoint) => number)[],
): [number, number] {
  const all = points.flatMap((point) => values.map((value) => value(point)));
  return [Math.min(...all), Math.max(...all)];
}

/** Objective, temperature, and below what the objective is made of, over the steps of the search. */
export function ProgressChart({ points }: { readonly points: readonly ChartPoint[] }) {
  const [at, setAt] = useState<number | null>(null);
  const label = fillWords(text.solve.chartText, {
    from: formatNumber(points[0]?.objective ?? 0, 2),
    to: formatNumber(points.at(-1)?.objective ?? 0, 2),
  });
  const below = termCurves(points);
  const [, high] = spanOf(
    points,
    below.map((curve) => curve.value),
  );
  const chosen = (at === null ? undefined : points[at]) ?? points.at(-1);
  const onMove = (event: PointerEvent) => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * WIDTH;
    const gaps = points.map((point) => Math.abs(placeOf(points, point) - x));
    setAt(gaps.indexOf(Math.min(...gaps)));
  };
  return (
    <figure class="chart" onPointerMove={onMove} onPointerLeave={() => setAt(null)}>
      <svg viewBox={`0 0 ${WIDTH} ${TALL + LOW}`} role="img" aria-label={label}>
        {ABOVE.map(({ look, value }) => (
          <path
            key={look}
            class={look}
            d={chartPath(points, value, spanOf(points, [value]), TALL)}
          />
        ))}
        <g transform={`translate(0 ${TALL})`}>
          <path class="rule" d={`M0 0H${WIDTH}`} />
          {below.map(({ look, value }) => (
            <path key={look} class={look} d={chartPath(points, value, [0, high], LOW)} />
          ))}
        </g>
        {at !== null && chosen ? (
          <path class="rule" d={`M${placeOf(points, chosen)} 0V${TALL + LOW}`} />
        ) : null}
      </svg>
      <figcaption>
        {[...ABOVE, ...below].map((curve) => (
          <span key={curve.look} class={`legend ${curve.look}`}>
            {curve.name} <b>{chosen ? shortNumber(curve.value(chosen)) : ''}</b>
          </span>
        ))}
      </figcaption>
    </figure>
  );
}

function shortNumber(value: number): string {
  return formatNumber(value, Number.isInteger(value) ? 0 : value < 1 ? 3 : 2);
}
