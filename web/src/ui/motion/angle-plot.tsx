import { motionWords as words } from '../checks/motion-words.ts';
import { formatNumber } from '../text/language.ts';

/** One line of the plot. */
export interface Curve {
  readonly name: string;
  /** Degrees, one for each moment. */
  readonly angles: readonly number[];
}

const WIDE = 320;
const TALL = 160;
const LEFT = 40;
const BOTTOM = 22;
const TOP = 8;
/** Told apart without colour too. */
const DASHES = ['none', '7 3', '2 3', '9 3 2 3'] as const;
const COLOURS = 6;
const STEPS = [1, 2, 5, 10, 15, 30, 45, 90, 180, 360] as const;
const MOST_ROWS = 5;

/** The angles of joints over the seconds of one period, and where the motion stands. */
export function AnglePlot(props: {
  readonly seconds: readonly number[];
  readonly curves: readonly Curve[];
  /** Null where the motion is not gone through. */
  readonly now: number | null;
}) {
  const { seconds, curves, now } = props;
  const period = seconds.at(-1) ?? 0;
  const all = curves.flatMap(({ angles }) => angles);
  if (all.length === 0 || period <= 0) {
    return null;
  }
  const [low, high] = [Math.min(0, ...all), Math.max(0, ...all)];
  const size = Math.max(1, high - low);
  const x = (second: number) => LEFT + ((WIDE - LEFT - 4) * second) / period;
  const y = (degrees: number) => TOP + ((TALL - TOP - BOTTOM) * (high - degrees)) / size;
  const step = STEPS.find((each) => size / each <= MOST_ROWS) ?? 360;
  const rows = ticks(low, high, step);
  return (
    <figure class="angle-plot">
      <svg viewBox={`0 0 ${WIDE} ${TALL}`} role="img" aria-label={aboutCurves(curves)}>
        {rows.map((degrees) => (
          <g key={degrees} class="tick">
            <line x1={LEFT} x2={WIDE - 4} y1={y(degrees)} y2={y(degrees)} />
            <text x={LEFT - 5} y={y(degrees)}>
              {formatNumber(degrees)}°
            </text>
          </g>
        ))}
        <text class="seconds" x={LEFT} y={TALL - 6}>
          0
        </text>
        <text class="seconds end" x={WIDE - 4} y={TALL - 6}>
          {words.seconds(formatNumber(period, 1))}
        </text>
        {curves.map(({ name, angles }, i) => (
          <polyline
            key={name}
            class={`curve curve-${i % COLOURS}`}
            stroke-dasharray={DASHES[i % DASHES.length]}
            points={angles.map((degrees, k) => `${x(seconds[k] ?? 0)},${y(degrees)}`).join(' ')}
          />
        ))}
        {now === null ? null : (
          <line class="now" x1={x(now)} x2={x(now)} y1={TOP} y2={TALL - BOTTOM} />
        )}
      </svg>
      <figcaption>
        {curves.map(({ name }, i) => (
          <span key={name}>
            <svg viewBox="0 0 22 8" aria-hidden="true">
              <line
                class={`curve curve-${i % COLOURS}`}
                stroke-dasharray={DASHES[i % DASHES.length]}
                x1="0"
                x2="22"
                y1="4"
                y2="4"
              />
            </svg>
            {name}
          </span>
        ))}
      </figcaption>
    </figure>
  );
}

function ticks(low: number, high: number, step: number): number[] {
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, i) => (first + i) * step);
}

function aboutCurves(curves: readonly Curve[]): string {
  const each = curves.map(({ name, angles }) =>
    words.curve(name, formatNumber(Math.min(...angles)), formatNumber(Math.max(...angles))),
  );
  return `${words.plot}: ${each.join('; ')}`;
}
