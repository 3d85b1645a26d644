import { useState } from 'preact/hooks';
import { AXIS_NAMES, type AxisName } from '../../geometry/vec.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { Segmented } from '../controls.tsx';
import { lessonWords as words } from './lesson-words.ts';
import { Praise } from './praise.tsx';

/** Corner of a cube: three beams along x, y and z that meet pairwise. */
const BEAMS: readonly AxisName[] = ['x', 'y', 'z'];
const PAIRS = [
  [0, 1],
  [1, 2],
  [0, 2],
] as const;

/** Screen direction of an axis in the figure. */
const SCREEN = { x: [0.9, 0.35], y: [-0.75, 0.45], z: [0, -1] } as const;
const CENTRE = { x: 150, y: 130 };
const REACH = 100;

/** Whether the two beams can be pinned where they meet. */
export function agrees(a: AxisName, b: AxisName): boolean {
  return a === b;
}

/** Choose hole axes: corners whose axes agree take a pin, others a connector. */
export function AxesLesson() {
  const [axes, setAxes] = useState<readonly AxisName[]>(['y', 'z', 'x']);
  const connectors = PAIRS.filter(([a, b]) => !agrees(axes[a] ?? 'x', axes[b] ?? 'y')).length;
  const choices = (beam: AxisName) =>
    AXIS_NAMES.filter((axis) => axis !== beam).map((value) => ({ value, label: value }));
  return (
    <>
      <svg class="lesson-figure" viewBox="0 0 300 220" role="img" aria-label={words.axes.figure}>
        {BEAMS.map((beam, i) => (
          <BeamFigure key={beam} along={beam} holes={axes[i] ?? 'x'} />
        ))}
      </svg>
      {BEAMS.map((beam, i) => (
        <div key={beam} class="lesson-row">
          <span>{fillWords(words.axes.beam, { n: i + 1, axis: beam })}</span>
          <Segmented
            name={`axis-${beam}`}
            legend={fillWords(words.axes.beam, { n: i + 1, axis: beam })}
            choices={choices(beam)}
            value={axes[i] ?? 'x'}
            onChange={(value) => setAxes(axes.map((axis, k) => (k === i ? value : axis)))}
          />
        </div>
      ))}
      <ul class="lesson-facts">
        {PAIRS.map(([a, b]) => {
          const fits = agrees(axes[a] ?? 'x', axes[b] ?? 'y');
          return (
            <li key={`${a}${b}`} class={fits ? 'good' : 'bad'}>
              {a + 1}–{b + 1}: {fits ? words.axes.pinned : words.axes.connector}
            </li>
          );
        })}
      </ul>
      <p data-testid="connectors">{fillWords(words.axes.count, { n: connectors })}</p>
      <Praise when={connectors === 2} words={words.axes.best} />
    </>
  );
}

function BeamFigure({ along, holes }: { readonly along: AxisName; readonly holes: AxisName }) {
  const [dx, dy] = SCREEN[along];
  const [hx, hy] = SCREEN[holes];
  return (
    <g>
      <path class="laid-beam thick" d={`M${CENTRE.x} ${CENTRE.y}l${dx * REACH} ${dy * REACH}`} />
      {[0.25, 0.5, 0.75, 1].map((t) => {
        const x = CENTRE.x + dx * REACH * t;
        const y = CENTRE.y + dy * REACH * t;
        return (
          <path
            key={t}
            class="hole-axis"
            d={`M${x - hx * 12} ${y - hy * 12}l${hx * 24} ${hy * 24}`}
          />
        );
      })}
    </g>
  );
}
