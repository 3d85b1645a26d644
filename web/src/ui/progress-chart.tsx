import { fillWords } from '../tools/tool-words.ts';
import type { ChartPoint } from './page.ts';
import { text } from './text.ts';

const WIDTH = 288;
const HEIGHT = 56;
const PAD = 3;

/** The points of a curve in the chart's box: time to the right, low objective at the bottom. */
export function chartPath(points: readonly ChartPoint[]): string {
  const xs = points.map((point) => point.iterations);
  const ys = points.map((point) => point.objective);
  const [x0, x1] = [Math.min(...xs), Math.max(...xs)];
  const [y0, y1] = [Math.min(...ys), Math.max(...ys)];
  const px = (x: number) => PAD + ((x - x0) / (x1 - x0 || 1)) * (WIDTH - 2 * PAD);
  const py = (y: number) => HEIGHT - PAD - ((y - y0) / (y1 - y0 || 1)) * (HEIGHT - 2 * PAD);
  return points
    .map((point, i) => {
      const at = `${px(point.iterations).toFixed(1)} ${py(point.objective).toFixed(1)}`;
      return `${i === 0 ? 'M' : 'L'}${at}`;
    })
    .join('');
}

/** The objective over the steps of the search. */
export function ProgressChart({ points }: { readonly points: readonly ChartPoint[] }) {
  const label = fillWords(text.solve.chartText, {
    from: (points[0]?.objective ?? 0).toFixed(2),
    to: (points.at(-1)?.objective ?? 0).toFixed(2),
  });
  return (
    <figure class="chart">
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={label}>
        <path d={chartPath(points)} />
      </svg>
      <figcaption class="quiet">{text.solve.chart}</figcaption>
    </figure>
  );
}
