import type { Preferences } from '../state/preferences.ts';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

const COLOURS: readonly { value: Preferences['colourBy']; label: string }[] = [
  { value: 'part', label: text.view.byPart },
  { value: 'layer', label: text.view.byLayer },
  { value: 'axis', label: text.view.byAxis },
  { value: 'component', label: text.view.byComponent },
  { value: 'piece', label: text.view.byPiece },
];

/** Moves the parts of the model from one another. */
export function ExplodeSlider({ class: name }: { readonly class?: string }) {
  const { explode, result } = usePage();
  return (
    <label class={`slider ${name ?? ''}`}>
      <span>{text.view.explode}</span>
      <input
        type="range"
        min="0"
        max="1"
        step="0.01"
        value={explode.value}
        disabled={result.value === null}
        onInput={(event) => {
          explode.value = Number(event.currentTarget.value);
        }}
      />
    </label>
  );
}

/** What the colours of the parts tell. */
export function ColourChoice({ class: name }: { readonly class?: string }) {
  const { preferences, result } = usePage();
  return (
    <label class={`select-field ${name ?? ''}`}>
      <span>{text.view.colour}</span>
      <select
        value={preferences.value.colourBy}
        disabled={result.value === null}
        title={text.view.colour}
        onChange={(event) => {
          const chosen = COLOURS.find((each) => each.value === event.currentTarget.value);
          if (chosen) {
            preferences.value = { ...preferences.peek(), colourBy: chosen.value };
          }
        }}
      >
        {COLOURS.map((each) => (
          <option key={each.value} value={each.value}>
            {each.label}
          </option>
        ))}
      </select>
    </label>
  );
}
