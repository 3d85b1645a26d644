import { useEffect, useRef, useState } from 'preact/hooks';
import { type Place, samePart } from '../../model/keep.ts';
import type { PlacedPart } from '../../model/model.ts';
import type { SketchDocument } from '../../model/sketch.ts';
import { cutStretches, mayCut } from '../../state/cut-lines.ts';
import { barPart, isKept, keepPart, releasePart, swapPart } from '../../state/keeps.ts';
import { paintPart } from '../../state/paint-lines.ts';
import { Icon, type IconName } from '../icon.tsx';
import { usePage } from '../page-context.ts';
import { LayerRow } from './layer-row.tsx';
import { PartColours } from './part-colours.tsx';
import { SwapList } from './swap-list.tsx';
import { touchWords as words } from './touch-words.ts';
import './touch.css';

/** The card goes while the model is solved again: whoever was in it by the keyboard is there afterwards. */
let returns = false;

/** What can be done with the part that is picked. */
export function PartActions({
  index,
  placed,
}: {
  readonly index: number;
  readonly placed: PlacedPart;
}) {
  const page = usePage();
  const [swapping, setSwapping] = useState<number | null>(null);
  const places = page.places.value;
  const place = places?.[index] ?? null;
  const sketch = page.store.sketch.value;
  const frame = useRef<HTMLDivElement>(null);
  const ready = place !== null && !page.stale.value;
  useEffect(() => {
    if (ready && returns) {
      returns = false;
      frame.current?.querySelector('button')?.focus({ preventScroll: true });
    }
  }, [ready]);
  const change = (label: string, next: SketchDocument, after: Place | null = place) => {
    returns = after !== null && (frame.current?.contains(document.activeElement) ?? false);
    page.touchModel({ label, next, index, place: after });
  };
  if (page.shown.value?.source !== 'search' || page.stale.value) {
    return page.stale.value ? <p class="quiet">{words.waiting}</p> : null;
  }
  return (
    <div class="part-actions" ref={frame}>
      {place ? (
        <Verbs
          place={place}
          sketch={sketch}
          swapping={swapping === index}
          onSwap={() => setSwapping(swapping === index ? null : index)}
          change={change}
        />
      ) : places ? (
        <p class="quiet">{words.follows}</p>
      ) : null}
      {place && swapping === index ? (
        <SwapList
          index={index}
          place={place}
          onTake={(other) => change(words.edits.swap, swapPart(sketch, place, other), other)}
        />
      ) : null}
      {place ? (
        <LayerRow
          index={index}
          place={place}
          onTake={(other) => change(words.edits.layer, swapPart(sketch, place, other), other)}
        />
      ) : null}
      <PartColours
        placed={placed}
        own={sketch.colours?.parts ?? []}
        onTake={(code) => {
          const twins = halves(page.shown.value?.model.parts ?? [], places, index);
          const next = twins.reduce(
            (painted, { part, position }) => paintPart(painted, { part, at: position }, code),
            sketch,
          );
          change(words.edits.colour, next);
        }}
      />
    </div>
  );
}

/** The part, and the other half where two thin ones make one beam. */
function halves(
  parts: readonly PlacedPart[],
  places: readonly (Place | null)[] | null,
  index: number,
): readonly PlacedPart[] {
  const place = places?.[index];
  return parts.filter((_, i) => {
    const other = places?.[i];
    return (
      i === index ||
      (place && other && other.line === place.line && samePart(other.part, place.part))
    );
  });
}

function Verbs(props: {
  readonly place: Place;
  readonly sketch: SketchDocument;
  readonly swapping: boolean;
  readonly onSwap: () => void;
  readonly change: (label: string, next: SketchDocument, after?: Place | null) => void;
}) {
  const { place, sketch, change } = props;
  const kept = isKept(sketch, place);
  const stretches = [{ line: place.line, ...place.part }, ...(place.part.with ?? [])];
  return (
    <>
      <div class="verbs">
        <Verb
          icon={kept ? 'unlock' : 'lock'}
          label={kept ? words.release : words.keep}
          pressed={kept}
          onClick={() =>
            kept
              ? change(words.edits.release, releasePart(sketch, place))
              : change(words.edits.keep, keepPart(sketch, place))
          }
        />
        <Verb icon="swap" label={words.swap} pressed={props.swapping} onClick={props.onSwap} />
        <Verb
          icon="ban"
          label={words.bar}
          onClick={() => change(words.edits.bar, barPart(sketch, place), null)}
        />
        <Verb
          icon="trash"
          label={words.remove}
          title={words.removeHint}
          disabled={!mayCut(sketch, stretches)}
          onClick={() => change(words.edits.remove, cutStretches(sketch, stretches), null)}
        />
      </div>
      {kept ? <p class="quiet">{words.kept}</p> : null}
    </>
  );
}

function Verb(props: {
  readonly icon: IconName;
  readonly label: string;
  readonly title?: string;
  readonly pressed?: boolean;
  readonly disabled?: boolean;
  readonly onClick: () => void;
}) {
  return (
    <button
      type="button"
      class="verb"
      title={props.title ?? props.label}
      aria-pressed={props.pressed}
      disabled={props.disabled}
      onClick={props.onClick}
    >
      <Icon name={props.icon} />
      <span>{props.label}</span>
    </button>
  );
}
