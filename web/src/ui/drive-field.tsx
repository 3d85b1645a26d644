import { useState } from 'preact/hooks';
import { couple, isRatio, lastPair } from '../state/shaft-edits.ts';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

/** Couples the two shafts drawn last: the ratio, as 5 or 5:3, and a button. */
export function DriveField() {
  const { store } = usePage();
  const [typed, setTyped] = useState('3');
  const pair = lastPair(store.sketch.value);
  const ratio = readRatio(typed);
  const run = () => {
    if (pair && ratio !== null) {
      store.commit(text.edits.drive, couple(store.sketch.value, { ...pair, ratio }));
    }
  };
  return (
    <form
      class="length-field"
      onSubmit={(event) => {
        event.preventDefault();
        run();
      }}
    >
      <label>
        <span>{text.draw.ratio}</span>
        <input
          inputMode="decimal"
          autocomplete="off"
          value={typed}
          disabled={!pair}
          onInput={(event) => setTyped(event.currentTarget.value)}
        />
      </label>
      <button type="submit" class="button" disabled={!pair || ratio === null}>
        {text.draw.couple}
      </button>
    </form>
  );
}

/** 5, 1.5, 1,5 or 5:3; null for what is no ratio. */
export function readRatio(typed: string): number | null {
  const [first = '', second = '1', ...more] = typed.replaceAll(',', '.').split(':');
  const ratio = Number(first) / Number(second);
  return more.length === 0 && first.trim() !== '' && second.trim() !== '' && isRatio(ratio)
    ? ratio
    : null;
}
