import { useEffect, useState } from 'preact/hooks';
import { AXIS_NAMES, type AxisName } from '../geometry/vec.ts';
import { modelBounds } from '../model/bounds.ts';
import { Segmented } from './controls.tsx';
import { Flyout } from './flyout.tsx';
import { usePage } from './page-context.ts';
import { text } from './text.ts';
import { ColourChoice, ExplodeSlider } from './view-controls.tsx';

type Cut = AxisName | 'none';

/** A cut through the model that can be moved; on narrow pages, the other ways to look inside too. */
export function LookInside() {
  const page = usePage();
  const { section, isolation, result } = page;
  const cut: Cut = section.value?.axis ?? 'none';
  return (
    <Flyout
      icon="cut"
      label={text.view.inside}
      active={section.value !== null || isolation.value !== null}
    >
      <div class="narrow-only flyout-narrow">
        <ExplodeSlider />
        <ColourChoice />
      </div>
      <div class="field">
        <span>{text.view.cut}</span>
        <Segmented
          name="cut"
          legend={text.view.cut}
          choices={[
            { value: 'none', label: text.view.cutNone },
            ...AXIS_NAMES.map((axis) => ({ value: axis, label: axis.toUpperCase() })),
          ]}
          value={cut}
          onChange={(axis) => {
            page.cutAlong(axis === 'none' ? null : axis);
          }}
        />
      </div>
      {cut === 'none' ? null : <CutSlider axis={cut} />}
      {isolation.value ? (
        <button
          type="button"
          class="button secondary small"
          onClick={() => {
            isolation.value = null;
          }}
        >
          {text.view.showAll}
        </button>
      ) : null}
      {result.value ? null : <p class="quiet">{text.result.noModel}</p>}
    </Flyout>
  );
}

function CutSlider({ axis }: { readonly axis: AxisName }) {
  const { shown, catalogue, section } = usePage();
  const model = shown.value?.model;
  const [box, setBox] = useState<ReturnType<typeof modelBounds>>(null);
  useEffect(() => setBox(model ? modelBounds(model, catalogue) : null), [model, catalogue]);
  const k = AXIS_NAMES.indexOf(axis);
  const low = box?.min[k] ?? 0;
  const high = box?.max[k] ?? 1;
  return (
    <label class="slider">
      <span>{text.view.cutAt}</span>
      <input
        type="range"
        min={low}
        max={high}
        step="0.1"
        value={section.value?.offset ?? high}
        onInput={(event) => {
          section.value = { axis, offset: Number(event.currentTarget.value) };
        }}
      />
    </label>
  );
}
