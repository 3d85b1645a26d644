import { SHAFT_ENDS, type ShaftEnd } from '../model/shafts.ts';
import { withEnds } from '../state/shaft-edits.ts';
import { usePage } from './page-context.ts';
import { text } from './text.ts';

const ENDS = ['atFrom', 'atTo'] as const;

/** What sits at either end of the shaft drawn last. */
export function ShaftEndsField() {
  const { store } = usePage();
  const sketch = store.sketch.value;
  const last = sketch.shafts?.at(-1);
  const put = (key: (typeof ENDS)[number], end: ShaftEnd | null) =>
    store.commit(text.edits.shaft, withEnds(sketch, { [key]: end }));
  return (
    <>
      {ENDS.map((key) => (
        <label key={key} class="length-field">
          <span>{text.draw[key]}</span>
          <select
            value={last?.[key] ?? ''}
            disabled={!last}
            onChange={(event) =>
              put(key, SHAFT_ENDS.find((end) => end === event.currentTarget.value) ?? null)
            }
          >
            <option value="">{text.draw.shaftBare}</option>
            {SHAFT_ENDS.map((end) => (
              <option key={end} value={end}>
                {text.draw[end]}
              </option>
            ))}
          </select>
        </label>
      ))}
    </>
  );
}
