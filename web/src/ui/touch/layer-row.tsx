import type { Place } from '../../model/keep.ts';
import { formatNumber } from '../text/language.ts';
import { touchWords as words } from './touch-words.ts';
import { useFits } from './use-fits.ts';

/** The layers that a part may be pulled to. */
export function LayerRow(props: {
  readonly index: number;
  readonly place: Place;
  readonly onTake: (place: Place) => void;
}) {
  const layers = useFits(props.index)?.layers ?? [];
  const all = [...layers, props.place].sort((a, b) => a.part.layer - b.part.layer);
  if (all.length < 2) {
    return null;
  }
  return (
    <fieldset class="layers">
      <legend>{words.layer}</legend>
      {all.map((place) => {
        const here = place === props.place;
        const layer = formatNumber(place.part.layer);
        return (
          <button
            key={place.part.layer}
            type="button"
            class="layer"
            aria-pressed={here}
            aria-label={words.layerTo(layer)}
            onClick={() => (here ? undefined : props.onTake(place))}
          >
            {layer}
          </button>
        );
      })}
    </fieldset>
  );
}
