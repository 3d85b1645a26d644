import type { RefObject } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { fillWords } from '../tools/tool-words.ts';
import { CommandButton } from './controls.tsx';
import { Icon } from './icon.tsx';
import type { Page } from './page.ts';
import { usePage } from './page-context.ts';
import { formatNumber } from './text/language.ts';
import { text } from './text.ts';
import { PartActions } from './touch/part-actions.tsx';

/** Around the middle of a part, CSS pixels: its padlock is to be seen too. */
const AROUND = 30;
/** A card of this share of the drawing's width leaves the drawing only what is above it. */
const WIDE_CARD = 0.6;

/** The card does not hide the part that it is about: the picture makes way. */
function useInSight(card: RefObject<HTMLElement | null>, page: Page, index: number | null): void {
  const known = page.places.value !== null;
  // The card is higher once it is known what can be done with the part.
  useEffect(() => {
    const view = page.view();
    const at = index === null ? null : view?.partCentre(index);
    const stage = card.current?.offsetParent?.getBoundingClientRect();
    const box = card.current?.getBoundingClientRect();
    if (!view || !at || !stage || !box) {
      return;
    }
    const seen = view.project(at);
    const [x, y] = [seen.x + stage.left, seen.y + stage.top];
    const beside = x < box.left - AROUND || x > box.right + AROUND;
    if (!beside && y > box.top - AROUND && y < box.bottom + AROUND) {
      const free = box.width > WIDE_CARD * stage.width ? box.top - stage.top : stage.height;
      view.centreOn(at, 0.5 - free / 2 / stage.height);
    }
  }, [card, page, index, known]);
}

/** The brick that was clicked: name, number, colour, how many, and what can be done with it. */
export function PartCard() {
  const page = usePage();
  const { pickedPart, shown, catalogue, result } = page;
  const index = pickedPart.value;
  const card = useRef<HTMLElement>(null);
  useInSight(card, page, index);
  const placed = index === null ? undefined : shown.value?.model.parts[index];
  if (!placed) {
    return null;
  }
  const part = catalogue.find(placed.part);
  const row = result.value?.rows.find(
    (each) => each.part === placed.part && each.color === placed.color,
  );
  return (
    <section ref={card} class="part-card floating" aria-label={text.part.title}>
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
