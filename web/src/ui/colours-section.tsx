import type { SketchDocument } from '../model/sketch.ts';
import { COLOUR_SCHEMES, type ColourPlan } from '../model/sketch-colours.ts';
import { paintLines, setBeamColour, setScheme } from '../state/paint-lines.ts';
import { Section, Segmented } from './controls.tsx';
import { usePage } from './page-context.ts';
import { SwatchButtons } from './swatch-buttons.tsx';
import { COLOURS_DE } from './text/de/colours.ts';
import { COLOURS_EN } from './text/en/colours.ts';
import { chooseWords, formatNumber } from './text/language.ts';
import './colours.css';

const words = chooseWords(COLOURS_EN, COLOURS_DE);

/** A scheme, or one colour for all beams. */
type Taken = ColourPlan | 'one';

const CHOICES = COLOUR_SCHEMES.map((value) => ({ value, label: words.schemes[value] }));

/** How the beams are coloured: by a scheme, all in one colour, and lines in their own. */
export function ColoursSection() {
  const page = usePage();
  const sketch = page.store.sketch.value;
  const selected = page.store.selection.value;
  const { colours } = sketch;
  const change = (next: SketchDocument) => page.store.commit(words.step, next);
  const painted = new Set([...selected].map((line) => colours?.lines?.[line] ?? null));
  const [only = null] = painted.size === 1 ? painted : [];
  const unusual = page.stale.value ? 0 : (page.result.value?.report.unusualColours ?? 0);
  return (
    <Section title={words.title}>
      <Segmented<Taken>
        name="colour-scheme"
        legend={words.scheme}
        choices={CHOICES}
        value={colours?.default === undefined ? (colours?.scheme ?? 'length') : 'one'}
        onChange={(scheme) =>
          change(setScheme(sketch, scheme === 'length' || scheme === 'one' ? null : scheme))
        }
      />
      <Swatches
        title={words.all}
        taken={colours?.default ?? null}
        onTake={(code) =>
          change(code === null ? setScheme(sketch, null) : setBeamColour(sketch, code))
        }
      />
      {selected.size > 0 ? (
        <Swatches
          title={words.selected(formatNumber(selected.size))}
          taken={only}
          onTake={(code) => change(paintLines(sketch, selected, code))}
        />
      ) : (
        <p class="quiet">{words.hint}</p>
      )}
      {unusual > 0 ? <p class="quiet">{words.unusual(formatNumber(unusual))}</p> : null}
    </Section>
  );
}

/** One colour of a row, or none of them. */
function Swatches(props: {
  readonly title: string;
  readonly taken: number | null;
  readonly onTake: (code: number | null) => void;
}) {
  return (
    <fieldset class="swatches">
      <legend>{props.title}</legend>
      <SwatchButtons taken={props.taken} nameOf={words.choose} onTake={props.onTake} />
      <button
        type="button"
        class="button secondary small"
        disabled={props.taken === null}
        onClick={() => props.onTake(null)}
      >
        {words.none}
      </button>
    </fieldset>
  );
}
