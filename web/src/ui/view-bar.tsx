import type { Preferences } from '../state/preferences.ts';
import { CommandButton, Segmented } from './controls.tsx';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

const SHOW: readonly { value: Preferences['show']; label: string }[] = [
  { value: 'sketch', label: text.view.sketch },
  { value: 'both', label: text.view.both },
  { value: 'model', label: text.view.model },
];

const COLOURS: readonly { value: Preferences['colourBy']; label: string }[] = [
  { value: 'part', label: text.view.byPart },
  { value: 'layer', label: text.view.byLayer },
  { value: 'axis', label: text.view.byAxis },
  { value: 'component', label: text.view.byComponent },
  { value: 'piece', label: text.view.byPiece },
];

/** How the scene is looked at. */
export function ViewBar() {
  const { preferences, explode, result } = usePage();
  const { show, colourBy } = preferences.value;
  const noModel = result.value === null;
  return (
    <div class="view-bar floating" role="toolbar" aria-label={text.view.title}>
      <Segmented
        name="show"
        legend={text.view.show}
        choices={SHOW}
        value={show}
        onChange={(value) => {
          preferences.value = { ...preferences.peek(), show: value };
        }}
      />
      <label class="slider wide-only">
        <span>{text.view.explode}</span>
        <input
          type="range"
          min="0"
          max="1"
          step="0.01"
          value={explode.value}
          disabled={noModel}
          onInput={(event) => {
            explode.value = Number(event.currentTarget.value);
          }}
        />
      </label>
      <label class="wide-only select-field">
        <span>{text.view.colour}</span>
        <select
          value={colourBy}
          disabled={noModel}
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
      <span class="divider wide-only" />
      <CommandButton id="viewIso" class="wide-only" />
      <CommandButton id="viewTop" class="wide-only" />
      <CommandButton id="viewFront" class="wide-only" />
      <CommandButton id="viewRight" class="wide-only" />
      <CommandButton id="projection" class="wide-only" />
      <CommandButton id="fit" />
    </div>
  );
}
