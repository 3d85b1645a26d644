import { BRICK_COLOURS, type BrickColour } from '../model/colours.ts';
import { colourWord } from './text/part-names.ts';
import './colours.css';

/** Those in which most beams are sold; the file format knows all. */
const OFFERED_CODES = [0, 1, 2, 4, 14, 15, 25, 27, 71, 72, 321];
const OFFERED = BRICK_COLOURS.filter(({ code }) => OFFERED_CODES.includes(code));

/** A button for each colour that is offered. */
export function SwatchButtons(props: {
  readonly taken: number | null;
  /** What a button does, in words. */
  readonly nameOf: (colour: string) => string;
  readonly onTake: (code: number) => void;
}) {
  return (
    <>
      {OFFERED.map((colour) => (
        <button
          key={colour.code}
          type="button"
          class="swatch-button"
          style={{ background: hexText(colour) }}
          aria-label={props.nameOf(colourWord(colour.code))}
          title={colourWord(colour.code)}
          aria-pressed={props.taken === colour.code}
          onClick={() => props.onTake(colour.code)}
        />
      ))}
    </>
  );
}

function hexText({ hex }: BrickColour): string {
  return `#${hex.toString(16).padStart(6, '0')}`;
}
