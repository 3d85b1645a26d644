import { useState } from 'preact/hooks';
import { fillWords } from '../../tools/tool-words.ts';
import { Segmented } from '../controls.tsx';
import { formatNumber } from '../text/language.ts';
import { type Curve, CurvesChart } from './curves-chart.tsx';
import type { LabSketch } from './lab-sketches.ts';
import { laboratoryWords as words } from './laboratory-words.ts';
import type { RacePoint, Run } from './race.ts';
import { sketchName } from './race-chooser.tsx';
import { METHODS } from './race-plan.ts';
import { exponentOf, type RaceResult } from './race-results.ts';

const OVER_TIME = ['objective', 'beams', 'gaps', 'faults'] as const;
type OverTime = (typeof OVER_TIME)[number];

/** Of the searches on one sketch: how what they look at came down. */
export function TimeChart({ runs }: { readonly runs: readonly Run[] }) {
  const [what, setWhat] = useState<OverTime>('beams');
  const sketches = [...new Set(runs.map(({ sketch }) => sketch))];
  const [chosen, setChosen] = useState<LabSketch | null>(null);
  const sketch = sketches.find((one) => one === chosen) ?? sketches[0];
  if (sketch === undefined) {
    return null;
  }
  const label = fillWords(words.timeChart, { what: words.over[what], sketch: sketchName(sketch) });
  return (
    <section>
      <h3>{words.overTime}</h3>
      <div class="lab-row">
        <Segmented
          name="lab-over-time"
          legend={words.overTime}
          choices={OVER_TIME.map((value) => ({ value, label: words.over[value] }))}
          value={what}
          onChange={setWhat}
        />
        {sketches.length > 1 ? (
          <label class="lab-select">
            <span>{words.sketch}</span>
            <select
              value={sketch.id}
              onChange={({ currentTarget }) =>
                setChosen(sketches.find(({ id }) => id === currentTarget.value) ?? null)
              }
            >
              {sketches.map((one) => (
                <option key={one.id} value={one.id}>
                  {sketchName(one)}
                </option>
              ))}
            </select>
          </label>
        ) : null}
      </div>
      <CurvesChart
        curves={runs.filter((run) => run.sketch === sketch).map((run) => curveOf(run, what))}
        axes={{ x: words.seconds, y: words.over[what], stepped: true }}
        label={label}
      />
      {what === 'objective' ? <p class="quiet">{words.objectiveNote}</p> : null}
    </section>
  );
}

function curveOf(run: Run, what: keyof Omit<RacePoint, 'seconds'>): Curve {
  const points = run.state.value.points.map((point) => ({ x: point.seconds, y: point[what] }));
  return { name: words.method[run.method], look: METHODS.indexOf(run.method), points };
}

const BY_LENGTH = ['seconds', 'beams', 'gaps'] as const;
type ByLength = (typeof BY_LENGTH)[number];

/** How results grow with the length of the drawing; of three sketches on there is an exponent. */
export function LengthChart({ results }: { readonly results: readonly RaceResult[] }) {
  const [what, setWhat] = useState<ByLength>('seconds');
  const lengths = new Set(results.map(({ length }) => length));
  if (lengths.size < 2) {
    return null;
  }
  const methods = METHODS.filter((id) => results.some(({ method }) => method === id));
  const curves = methods.map((id): Curve => {
    const points = results
      .filter(({ method }) => method === id)
      .map((one) => ({ x: one.length, y: one[what] }))
      .sort((a, b) => a.x - b.x);
    return { name: words.method[id], look: METHODS.indexOf(id), points, marked: true };
  });
  const fits = curves.flatMap(({ name, points }) => {
    const exponent = exponentOf(points);
    return exponent === null ? [] : [`${name} ${formatNumber(exponent, 2)}`];
  });
  return (
    <section>
      <h3>{words.byLength}</h3>
      <Segmented
        name="lab-by-length"
        legend={words.byLength}
        choices={BY_LENGTH.map((value) => ({ value, label: words.by[value] }))}
        value={what}
        onChange={setWhat}
      />
      <CurvesChart
        curves={curves}
        axes={{ x: words.lengthAxis, y: words.by[what], logarithmic: what !== 'gaps' }}
        label={fillWords(words.lengthChart, { what: words.by[what] })}
      />
      {fits.length > 0 && what !== 'gaps' ? (
        <p class="quiet">
          {fillWords(words.exponents, { what: words.by[what], fits: fits.join(', ') })}
        </p>
      ) : null}
    </section>
  );
}
