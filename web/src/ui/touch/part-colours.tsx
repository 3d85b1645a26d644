import { distance } from '../../geometry/vec.ts';
import type { PlacedPart } from '../../model/model.ts';
import type { PaintedPart } from '../../model/sketch-colours.ts';
import { SwatchButtons } from '../swatch-buttons.tsx';
import { touchWords as words } from './touch-words.ts';

const SAME_PLACE = 0.01;

/** Colours for one part of the model. */
export function PartColours(props: {
  readonly placed: PlacedPart;
  /** Parts that have colours of their own. */
  readonly own: readonly PaintedPart[];
  readonly onTake: (code: number | null) => void;
}) {
  const { part, position, color } = props.placed;
  const mine = props.own.find(
    (painted) => painted.part === part && distance(painted.at, position) < SAME_PLACE,
  );
  return (
    <fieldset class="swatches small">
      <legend>{words.colour}</legend>
      <SwatchButtons taken={color} nameOf={words.ownColour} onTake={props.onTake} />
      {mine ? (
        <button type="button" class="button secondary small" onClick={() => props.onTake(null)}>
          {words.noColour}
        </button>
      ) : null}
    </fieldset>
  );
}
