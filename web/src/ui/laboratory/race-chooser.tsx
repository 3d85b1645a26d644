import { fillWords } from '../../tools/tool-words.ts';
import { Segmented } from '../controls.tsx';
import type { LabGroup, LabSketch } from './lab-sketches.ts';
import { laboratoryWords as words } from './laboratory-words.ts';
import {
  BRICKS,
  MAX_SEED,
  METHODS,
  type MethodId,
  MOVES,
  type RacePlan,
  toggled,
} from './race-plan.ts';

const GROUPS: readonly LabGroup[] = ['mine', 'grids', 'cubes', 'examples'];

/** What a sketch is called among those of its group. */
export function shortName({ group, size, sketch }: LabSketch): string {
  return group === 'examples' ? (sketch.name ?? '') : fillWords(words.sizes[group], { n: size });
}

/** What a sketch is called by itself. */
export function sketchName(sketch: LabSketch): string {
  const { group, size } = sketch;
  return group === 'examples'
    ? shortName(sketch)
    : fillWords(words.sketchNames[group], { n: size });
}

/** What is to race: a fieldset each for sketches and methods, and the rules for all. */
export function RaceChooser(props: {
  readonly plan: RacePlan;
  readonly sketches: readonly LabSketch[];
  readonly disabled: boolean;
  readonly onChange: (plan: RacePlan) => void;
}) {
  const { plan, sketches, disabled, onChange } = props;
  const ids = sketches.map(({ id }) => id);
  return (
    <div class="lab-choices">
      <fieldset disabled={disabled}>
        <legend>{words.sketches}</legend>
        {GROUPS.map((group) => (
          <SketchGroup
            key={group}
            group={group}
            sketches={sketches.filter((one) => one.group === group)}
            chosen={plan.sketches}
            onToggle={(id) => onChange({ ...plan, sketches: toggled(ids, plan.sketches, id) })}
          />
        ))}
      </fieldset>
      <fieldset disabled={disabled}>
        <legend>{words.methods}</legend>
        <ul class="lab-methods">
          {METHODS.map((method) => (
            <li key={method}>
              <label>
                <input
                  type="checkbox"
                  checked={plan.methods.includes(method)}
                  onChange={() =>
                    onChange({
                      ...plan,
                      methods: toggled<MethodId>(METHODS, plan.methods, method),
                    })
                  }
                />
                <span>{words.method[method]}</span>
              </label>
              <p class="quiet">{words.methodText[method]}</p>
            </li>
          ))}
        </ul>
      </fieldset>
      <fieldset disabled={disabled} class="lab-rules">
        <legend>{words.rules}</legend>
        <span class="quiet">{words.moves}</span>
        <Segmented
          name="lab-moves"
          legend={words.moves}
          choices={MOVES.map((value) => ({ value, label: words.movesOf[value] }))}
          value={plan.moves}
          onChange={(moves) => onChange({ ...plan, moves })}
        />
        <span class="quiet">{words.bricks}</span>
        <Segmented
          name="lab-bricks"
          legend={words.bricks}
          choices={BRICKS.map((value) => ({ value, label: words.bricksOf[value] }))}
          value={plan.bricks}
          onChange={(bricks) => onChange({ ...plan, bricks })}
        />
        <label class="lab-seed">
          <span>{words.seed}</span>
          <input
            type="number"
            min={0}
            max={MAX_SEED}
            value={plan.seed}
            onChange={(event) => {
              const seed = Math.round(event.currentTarget.valueAsNumber);
              onChange({ ...plan, seed: seed >= 0 && seed <= MAX_SEED ? seed : plan.seed });
            }}
          />
        </label>
      </fieldset>
    </div>
  );
}

function SketchGroup(props: {
  readonly group: LabGroup;
  readonly sketches: readonly LabSketch[];
  readonly chosen: readonly string[];
  readonly onToggle: (id: string) => void;
}) {
  const { group, sketches, chosen, onToggle } = props;
  return sketches.length === 0 ? null : (
    <div class="lab-group">
      <span class="quiet">{words.groups[group]}</span>
      <span class="lab-chips">
        {sketches.map((sketch) => (
          <label key={sketch.id} class="lab-chip">
            <input
              type="checkbox"
              aria-label={sketchName(sketch)}
              checked={chosen.includes(sketch.id)}
              onChange={() => onToggle(sketch.id)}
            />
            <span>{shortName(sketch)}</span>
          </label>
        ))}
      </span>
    </div>
  );
}
