import type { JSX } from 'preact';
import type { LessonId } from './lesson-table.ts';
import './lesson-picture.css';

/** A beam with its holes, from a hole to another, `n` of them. */
function Beam(props: {
  readonly from: readonly [number, number];
  readonly to: readonly [number, number];
  readonly n: number;
  readonly class?: string;
}) {
  const { from, to, n } = props;
  const holes = Array.from({ length: n }, (_, i) => {
    const t = i / (n - 1);
    return [from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t] as const;
  });
  return (
    <g class={`lesson-beam ${props.class ?? ''}`}>
      <path d={`M${from.join(' ')}L${to.join(' ')}`} />
      {holes.map(([cx, cy]) => (
        <circle key={`${cx} ${cy}`} cx={cx} cy={cy} r="4" />
      ))}
    </g>
  );
}

/** A row of nodes on a line. */
function Nodes({ y, n }: { readonly y: number; readonly n: number }) {
  return (
    <g class="lesson-nodes">
      <path d={`M40 ${y}H${40 + 20 * (n - 1)}`} />
      {Array.from({ length: n }, (_, i) => (
        <circle key={i} cx={40 + 20 * i} cy={y} r="3.5" />
      ))}
    </g>
  );
}

const PICTURES: Readonly<Record<LessonId, () => JSX.Element>> = {
  graph: () => (
    <>
      <Nodes y={34} n={9} />
      <Nodes y={88} n={7} />
      <Beam from={[40, 34]} to={[120, 34]} n={5} class="new" />
    </>
  ),
  axes: () => (
    <>
      <Beam from={[70, 92]} to={[70, 24]} n={4} />
      <Beam from={[70, 92]} to={[170, 92]} n={6} class="new" />
      <Beam from={[150, 72]} to={[190, 32]} n={3} />
    </>
  ),
  annealing: () => (
    <>
      <path class="lesson-axis" d="M36 16V102H206" />
      <path
        class="lesson-curve"
        d="M40 30l8 14 7-20 9 34 8-22 9 30 8-16 10 26 9-14 10 20 12-6 12 10 16-4 20 6 26 0"
      />
    </>
  ),
  folding: () => (
    <>
      <Beam from={[60, 98]} to={[150, 98]} n={6} />
      <Beam from={[86, 26]} to={[176, 26]} n={6} />
      <Beam from={[60, 98]} to={[86, 26]} n={5} />
      <Beam from={[150, 98]} to={[176, 26]} n={5} />
      <path class="lesson-dashed" d="M60 98L176 26" />
    </>
  ),
  puzzle: () => (
    <>
      {[28, 60, 92].map((y) => (
        <path key={y} class="lesson-axis" d={`M70 ${y}H170`} />
      ))}
      {[72, 120, 168].map((x) => (
        <path key={x} class="lesson-axis" d={`M${x} 26V94`} />
      ))}
      <Beam from={[72, 28]} to={[168, 28]} n={5} />
      <Beam from={[120, 28]} to={[120, 92]} n={4} class="new" />
    </>
  ),
  apart: () => (
    <>
      <Beam from={[60, 92]} to={[180, 92]} n={7} />
      <Beam from={[100, 48]} to={[140, 48]} n={3} class="new" />
      <path class="lesson-dashed" d="M100 84V58M140 84V58" />
      <path class="lesson-arrow" d="M120 36V14M112 22l8-8 8 8" />
    </>
  ),
};

/** What a lesson is about, at a glance. */
export function LessonPicture({ id }: { readonly id: LessonId }) {
  const Picture = PICTURES[id];
  return (
    <svg class="lesson-picture" viewBox="0 0 240 120" aria-hidden="true">
      <Picture />
    </svg>
  );
}
