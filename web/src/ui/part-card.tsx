import { fillWords } from '../tools/tool-words.ts';
import { CommandButton } from './controls.tsx';
import { Icon } from './icon.tsx';
import { usePage } from './page-context.ts';
import { formatNumber } from './text/language.ts';
import { text } from './text.ts';
import { PartActions } from './touch/part-actions.tsx';

/** The brick that was clicked: name, number, colour, how many, and what can be done with it. */
export function PartCard() {
  const page = usePage();
  const { pickedPart, shown, catalogue, result } = page;
  const index = pickedPart.value;
  const placed = index === null ? undefined : shown.value?.model.parts[index];
  if (!placed) {
    return null;
  }
  const part = catalogue.find(placed.part);
  const row = result.value?.rows.find(
    (each) => each.part === placed.part && each.color === placed.color,
  );
  return (
    <section class="part-card floating" aria-label={text.part.title}>
      <header>
        <span class="swatch" style={{ background: row?.swatch }} />
        <h3>{row?.name ?? placed.part}</h3>
        <button
          type="button"
          class="icon-button small"
          aria-label={text.app.close}
          onClick={() => {
            pickedPart.value = null;
          }}
        >
          <Icon name="close" />
        </button>
      </header>
      <dl>
        <dt>{text.part.number}</dt>
        <dd>{placed.part}</dd>
        <dt>{text.result.colour}</dt>
        <dd>{row?.colourName}</dd>
        <dt>{text.result.count}</dt>
        <dd>
          {fillWords(text.part.ofModel, { n: row?.count ?? 1, all: result.value?.bricks ?? 1 })}
        </dd>
        {part ? <dt>{text.result.mass}</dt> : null}
        {part ? (
          <dd>{fillWords(text.result.massText, { n: formatNumber(part.mass, 1) })}</dd>
        ) : null}
        {placed.component >= 0 ? <dt>{text.view.byLayer}</dt> : null}
        {placed.component >= 0 ? <dd>{placed.layer}</dd> : null}
      </dl>
      <PartActions index={index ?? 0} placed={placed} />
      <div class="actions">
        <CommandButton id="isolateSame" words={text.part.isolateSame} class="secondary small" />
        <CommandButton id="isolatePiece" words={text.part.isolateNear} class="secondary small" />
        <CommandButton id="isolateNone" words={text.view.showAll} class="secondary small" />
      </div>
    </section>
  );
}
