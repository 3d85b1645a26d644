import { useEffect, useState } from 'preact/hooks';
import type { WellBuilt, WellBuiltItem } from '../../model/report.ts';
import { Section } from '../controls.tsx';
import { Icon } from '../icon.tsx';
import { usePage } from '../page-context.ts';
import { formatNumber } from '../text/language.ts';
import { inWords } from '../text/sentences.ts';
import { builtWords as words } from './built-words.ts';
import { builtNumber, litParts } from './well-built.ts';
import './motion.css';

const SHOWN_PLACES = 12;
/** What a builder would not leave so. */
const LIT_HEX = 0xd9483b;

/** What a builder expects beyond the contract; an open item lights its places in the scene. */
export function WellBuiltSection({ built }: { readonly built: WellBuilt }) {
  const [open, setOpen] = useState<string | null>(null);
  const note = words.passed(formatNumber(built.passed), formatNumber(built.of));
  return (
    <Section title={words.title} note={note}>
      <p class="quiet">{words.about}</p>
      <ul class="checks" data-testid="well-built">
        {built.items.map((item) => (
          <ItemRow
            key={item.id}
            item={item}
            open={open === item.id}
            onToggle={(now) => {
              setOpen((before) => (now ? item.id : before === item.id ? null : before));
            }}
          />
        ))}
      </ul>
    </Section>
  );
}

function ItemRow(props: {
  readonly item: WellBuiltItem;
  readonly open: boolean;
  readonly onToggle: (open: boolean) => void;
}) {
  const { item, open } = props;
  const state = item.applies ? (item.ok ? 'ok' : 'bad') : 'none';
  return (
    <li class={`check-view ${state}`}>
      <details open={open} onToggle={(event) => props.onToggle(event.currentTarget.open)}>
        <summary>
          <Icon name={state === 'none' ? 'info' : item.ok ? 'check' : 'alert'} />
          <span>{inWords(item.title)}</span>
          <span class="quiet">{builtNumber(item)}</span>
        </summary>
        {open ? <Places item={item} /> : null}
      </details>
    </li>
  );
}

/** Where an item falls short. Mounted while it is open: lights all places, or the one that was pressed. */
function Places({ item }: { readonly item: WellBuiltItem }) {
  const page = usePage();
  const [pressed, setPressed] = useState<number | null>(null);
  useEffect(() => {
    const lit = litParts(item, pressed);
    const count = page.shown.value?.model.parts.length ?? 0;
    page.display.value =
      lit.size === 0
        ? null
        : {
            colours: Array.from({ length: count }, (_, i) => (lit.has(i) ? LIT_HEX : null)),
            highlighted: lit,
          };
    return () => {
      page.display.value = null;
    };
  }, [page, item, pressed]);
  const show = (index: number) => {
    const same = pressed === index;
    setPressed(same ? null : index);
    const place = same ? undefined : item.places[index];
    if (place) {
      page.announce(inWords(place.message));
    }
    if (place?.at) {
      page.showPlace(place.at);
    }
  };
  const more = item.places.length - SHOWN_PLACES;
  return (
    <div class="motion-check">
      <p class="quiet">{inWords(item.detail)}</p>
      {item.ok || item.places.length > 0 ? null : <p class="quiet">{words.nowhere}</p>}
      <ul class="motion-list">
        {item.places.slice(0, SHOWN_PLACES).map((place, i) => (
          <li key={`${place.kind}${place.message}`}>
            <button
              type="button"
              class="problem"
              aria-pressed={pressed === i}
              onClick={() => show(i)}
            >
              <span>{inWords(place.message)}</span>
            </button>
          </li>
        ))}
      </ul>
      {more > 0 ? <p class="quiet">{words.more(formatNumber(more))}</p> : null}
    </div>
  );
}
