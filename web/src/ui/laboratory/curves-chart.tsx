import { formatNumber } from '../text/language.ts';

/** A curve by the place of its name in the list of methods, which gives it its look. */
export interface Curve {
  readonly name: string;
  readonly look: number;
  readonly points: readonly { readonly x: number; readonly y: number }[];
  /** Where each point is a value of its own, it is marked. */
  readonly marked?: boolean;
}

export interface Axes {
  readonly x: string;
  readonly y: string;
  /** Both axes; values that are not above 0 are left out. */
  readonly logarithmic?: boolean;
  /** Values stay until the next one, as counts do. */
  readonly stepped?: boolean;
}

const BOX = { width: 560, height: 260, left: 52, right: 12, top: 12, bottom: 34 } as const;
const TICKS = 5;

type Scale = (value: number) => number;

/** Several curves in one box, with their axes. */
export function CurvesChart(props: {
  readonly curves: readonly Curve[];
  readonly axes: Axes;
  readonly label: string;
}) {
  const { axes, label } = props;
  const curves = props.curves.map((curve) => ({ ...curve, points: shownPoints(curve, axes) }));
  const all = curves.flatMap(({ points }) => points);
  if (all.length === 0) {
    return null;
  }
  const xs = spanOf(
    all.map(({ x }) => x),
    axes,
  );
  const ys = spanOf(
    all.map(({ y }) => y),
    axes,
  );
  const px = scaleOf(xs, [BOX.left, BOX.width - BOX.right], axes);
  const py = scaleOf(ys, [BOX.height - BOX.bottom, BOX.top], axes);
  return (
    <figure class="curves">
      <svg viewBox={`0 0 ${BOX.width} ${BOX.height}`} role="img" aria-label={label}>
        {ticksOf(xs, axes).map((x) => (
          <g key={`x${x}`}>
            <path class="rule" d={`M${px(x)} ${BOX.top}V${BOX.height - BOX.bottom}`} />
            <text x={px(x)} y={BOX.height - BOX.bottom + 14} text-anchor="middle">
              {tickText(x)}
            </text>
          </g>
        ))}
        {ticksOf(ys, axes).map((y) => (
          <g key={`y${y}`}>
            <path class="rule" d={`M${BOX.left} ${py(y)}H${BOX.width - BOX.right}`} />
            <text x={BOX.left - 6} y={py(y) + 4} text-anchor="end">
              {tickText(y)}
            </text>
          </g>
        ))}
        <text x={(BOX.left + BOX.width) / 2} y={BOX.height - 4} text-anchor="middle">
          {axes.x}
        </text>
        <text transform={`translate(12 ${BOX.height / 2}) rotate(-90)`} text-anchor="middle">
          {axes.y}
        </text>
        {curves.map(({ name, look, points, marked }) => (
          <g key={name} class={`curve look-${look}`}>
            <path d={pathOf(points, { px, py, stepped: axes.stepped === true })} />
            {marked || points.length === 1
              ? points.map(({ x, y }) => <circle cx={px(x)} cy={py(y)} r="3" />)
              : null}
          </g>
        ))}
      </svg>
      <figcaption>
        {curves.map(({ name, look }) => (
          <span key={name} class={`legend look-${look}`}>
            <svg viewBox="0 0 24 8" aria-hidden="true">
              <path d="M0 4H24" />
            </svg>
            {name}
          </span>
        ))}
      </figcaption>
    </figure>
  );
}

function shownPoints({ points }: Curve, { logarithmic }: Axes) {
  return logarithmic ? points.filter(({ x, y }) => x > 0 && y > 0) : points;
}

function spanOf(values: readonly number[], { logarithmic }: Axes): readonly [number, number] {
  const least = Math.min(...values);
  const most = Math.max(...values);
  if (logarithmic) {
    return least < most ? [least, most] : [least / 2, most * 2];
  }
  // Counts and seconds begin at nought, so that twice as much looks like it.
  const low = Math.min(0, least);
  return low < most ? [low, most] : [low, low + 1];
}

function scaleOf(
  [low, high]: readonly [number, number],
  [from, to]: readonly [number, number],
  { logarithmic }: Axes,
): Scale {
  const f = logarithmic ? Math.log : (value: number) => value;
  return (value) => {
    const share = (f(value) - f(low)) / (f(high) - f(low));
    return Math.round((from + share * (to - from)) * 10) / 10;
  };
}

/** Round values in a span: 1, 2 and 5 times powers of ten. */
export function ticksOf(
  [low, high]: readonly [number, number],
  { logarithmic = false }: Pick<Axes, 'logarithmic'>,
): number[] {
  if (logarithmic) {
    const first = Math.floor(Math.log10(low));
    const last = Math.ceil(Math.log10(high));
    const decades = Array.from({ length: last - first + 1 }, (_, i) => 10 ** (first + i));
    const steps = last - first > 3 ? [1] : [1, 2, 5];
    return decades
      .flatMap((decade) => steps.map((step) => Number((step * decade).toPrecision(1))))
      .filter((tick) => tick >= low && tick <= high);
  }
  const rough = (high - low) / TICKS;
  const decade = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 5, 10].find((n) => n * decade >= rough) ?? 10) * decade;
  const count = Math.floor((high - Math.ceil(low / step) * step) / step + 1e-9) + 1;
  return Array.from({ length: count }, (_, i) =>
    Number(((Math.ceil(low / step) + i) * step).toPrecision(6)),
  );
}

function tickText(value: number): string {
  return formatNumber(value, String(value).split('.')[1]?.length ?? 0);
}

function pathOf(
  points: Curve['points'],
  { px, py, stepped }: { readonly px: Scale; readonly py: Scale; readonly stepped: boolean },
): string {
  return points
    .map(({ x, y }, i) => {
      const begin = i === 0 ? 'M' : stepped ? `H${px(x)}L` : 'L';
      return `${begin}${px(x)} ${py(y)}`;
    })
    .join('');
}
