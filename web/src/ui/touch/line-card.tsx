import { useState } from 'preact/hooks';
import type { AxisName } from '../../geometry/vec.ts';
import type { Keep, Place } from '../../model/keep.ts';
import { lineLength, type SketchDocument } from '../../model/sketch.ts';
import { freeLine, isKept, keepOf, setLayers, toggleSplit } from '../../state/keeps.ts';
import { type Choice, IconButton, Segmented } from '../controls.tsx';
import { Icon } from '../icon.tsx';
import { usePage } from '../page-context.ts';
import { formatNumber } from '../text/language.ts';
import { partName } from '../text/part-names.ts';
import { text } from '../text.ts';
import { touchWords as words } from './touch-words.ts';
import './touch.css';

type Side = 'any' | 'on' | 'plus' | 'minus';

const LAYERS: Readonly<Record<Side, readonly number[] | null>> = {
  any: null,
  on: [0],
  plus: [1, 2],
  minus: [-2, -1],
};

/** The line that is selected, while no part is: its side, where its beams end, which beams lie on it. */
export function LineCard() {
  const page = usePage();
  const { store, shown, pickedPart, tool } = page;
  const [line] = store.selection.value;
  const one = store.selection.value.size === 1 && line !== undefined;
  const sketch = store.sketch.value;
  const drawn = one ? sketch.lines[line] : undefined;
  if (!drawn || line === undefined || tool.value.id !== 'select' || pickedPart.value !== null) {
    return null;
  }
  if (shown.value?.source !== 'search') {
    return null;
  }
  const length = Math.round(lineLength(drawn));
  const change = (label: string, next: SketchDocument) =>
    page.touchModel({ label, next, index: null, place: null });
  const keep = keepOf(sketch, line);
  const title = words.line.title(formatNumber(line + 1), formatNumber(length));
  return (
    <section class="part-card line-card floating" aria-label={title}>
      <header>
        <h3>{title}</h3>
        <IconButton
          icon="close"
          class="small"
          label={text.app.close}
          onClick={() => {
            store.select([]);
          }}
        />
      </header>
      <Sides
        keep={keep}
        axis={axisOn(page.places.value, line)}
        onTake={(layers) => change(words.edits.side, setLayers(sketch, line, layers))}
      />
      <Splits
        key={line}
        keep={keep}
        length={length}
        onToggle={(node) => change(words.edits.split, toggleSplit(sketch, line, node))}
      />
      <BeamsOn line={line} />
      {sketch.keep?.some((other) => other.line === line) ? (
        <button
          type="button"
          class="button secondary small"
          onClick={() => change(words.edits.free, freeLine(sketch, line))}
        >
          {words.line.free}
        </button>
      ) : null}
    </section>
  );
}

/** Along which axis the holes of the beams on a line go; null where that is not known. */
function axisOn(places: readonly (Place | null)[] | null, line: number): AxisName | null {
  return places?.find((place) => place?.line === line)?.part.holeAxis ?? null;
}

function Sides(props: {
  readonly keep: Keep;
  readonly axis: AxisName | null;
  readonly onTake: (layers: readonly number[] | null) => void;
}) {
  const axis = props.axis?.toUpperCase() ?? '';
  const choices: readonly Choice<Side>[] = [
    { value: 'any', label: words.line.any },
    { value: 'on', label: words.line.on },
    { value: 'plus', label: words.line.plus(axis) },
    { value: 'minus', label: words.line.minus(axis) },
  ];
  const now = JSON.stringify(props.keep.layers ?? null);
  const side = choices.find(({ value }) => JSON.stringify(LAYERS[value]) === now)?.value ?? 'any';
  return (
    <div class="sides">
      <span class="quiet">{words.line.side}</span>
      <Segmented<Side>
        name="line-side"
        legend={words.line.side}
        choices={choices}
        value={side}
        onChange={(value) => props.onTake(LAYERS[value])}
      />
    </div>
  );
}

function Splits(props: {
  readonly keep: Keep;
  readonly length: number;
  readonly onToggle: (node: number) => void;
}) {
  const [node, setNode] = useState(Math.floor(props.length / 2));
  const splits = props.keep.splits ?? [];
  if (props.length < 4) {
    return null;
  }
  return (
    <div class="splits">
      <label>
        <span class="quiet">{words.line.split}</span>
        <input
          type="number"
          min={1}
          max={props.length - 1}
          value={node}
          onInput={(event) => setNode(event.currentTarget.valueAsNumber)}
        />
      </label>
      <button
        type="button"
        class="button secondary small"
        disabled={
          !Number.isInteger(node) || node < 1 || node >= props.length || splits.includes(node)
        }
        onClick={() => props.onToggle(node)}
      >
        {words.line.splitAdd}
      </button>
      {splits.map((split) => (
        <button
          key={split}
          type="button"
          class="chip"
          aria-label={words.line.splitRemove(formatNumber(split))}
          onClick={() => props.onToggle(split)}
        >
          {formatNumber(split)} ×
        </button>
      ))}
    </div>
  );
}

/** The beams on a line; a click picks one. */
function BeamsOn({ line }: { readonly line: number }) {
  const page = usePage();
  const sketch = page.store.sketch.value;
  const onLine = (place: Place | null): place is Place =>
    place !== null &&
    (place.line === line || (place.part.with ?? []).some((bar) => bar.line === line));
  const seen = new Set<string>();
  const beams = (page.places.value ?? []).flatMap((place, index) => {
    const key = JSON.stringify(place);
    if (!onLine(place) || seen.has(key)) {
      return [];
    }
    seen.add(key);
    return [{ place, index }];
  });
  if (beams.length === 0 || page.stale.value) {
    return null;
  }
  return (
    <fieldset class="beams-on">
      <legend>{words.line.beams}</legend>
      {beams.map(({ place, index }) => (
        <button
          key={index}
          type="button"
          class="button secondary small"
          onClick={() => {
            page.pickedPart.value = index;
          }}
        >
          {isKept(sketch, place) ? <Icon name="lock" /> : null}
          <span>{partName(place.part.part, page.catalogue)}</span>
        </button>
      ))}
    </fieldset>
  );
}
