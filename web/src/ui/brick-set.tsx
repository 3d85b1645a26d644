import { useEffect, useState } from 'preact/hooks';
import { NEEDED_PARTS, SET_PARTS } from '../model/brick-set.ts';
import { fillWords } from '../tools/tool-words.ts';
import { Dialog } from './dialog.tsx';
import { Icon } from './icon.tsx';
import { OwnedPreview } from './owned-preview.tsx';
import { usePage } from './page-context.ts';
import { partName } from './text/part-names.ts';
import { text } from './text.ts';

const MOST_OWNED = 9999;

/** The parts that the search may use: each with a picture, a switch and how many there are. */
export function BrickSet() {
  const page = usePage();
  const { preferences } = page;
  const { off, owned } = preferences.value;
  const counted = Object.keys(owned).length > 0;
  const read = page.ownedList.value;
  if (read) {
    return (
      <Dialog title={text.bricks.title} class="bricks">
        <OwnedPreview read={read} />
      </Dialog>
    );
  }
  return (
    <Dialog title={text.bricks.title} class="bricks">
      <div class="dialog-bar">
        <p class="quiet">{text.bricks.text}</p>
        <button type="button" class="button secondary" onClick={page.importOwned}>
          <Icon name="open" />
          <span>{text.bricks.import}</span>
        </button>
        <button
          type="button"
          class="button secondary"
          disabled={!counted && off.length === 0}
          onClick={() => {
            preferences.value = { ...preferences.peek(), off: [], owned: {} };
          }}
        >
          {text.bricks.reset}
        </button>
      </div>
      <ul class="brick-grid">
        {SET_PARTS.map((id) => (
          <BrickCard key={id} id={id} />
        ))}
      </ul>
    </Dialog>
  );
}

function BrickCard({ id }: { readonly id: string }) {
  const { preferences, catalogue } = usePage();
  const { off, owned } = preferences.value;
  const name = partName(id, catalogue);
  const needed = NEEDED_PARTS.has(id);
  const on = needed || !off.includes(id);
  const setOwned = (value: string) => {
    const { [id]: _dropped, ...rest } = preferences.peek().owned;
    const count = Math.floor(Number(value));
    const known = value.trim() !== '' && count >= 0;
    preferences.value = {
      ...preferences.peek(),
      owned: known ? { ...rest, [id]: Math.min(count, MOST_OWNED) } : rest,
    };
  };
  return (
    <li class={on ? 'brick-card' : 'brick-card off'}>
      <PartPicture id={id} />
      <label class="check-row" title={needed ? text.bricks.needed : undefined}>
        <input
          type="checkbox"
          checked={on}
          disabled={needed}
          onChange={(event) => {
            const others = off.filter((each) => each !== id);
            const next = event.currentTarget.checked ? others : [...others, id];
            preferences.value = { ...preferences.peek(), off: next };
          }}
        />
        <span>
          {name} <span class="quiet">{id}</span>
        </span>
      </label>
      <label class="owned">
        <span>{text.bricks.owned}</span>
        <input
          type="number"
          min="0"
          max={MOST_OWNED}
          inputMode="numeric"
          placeholder="∞"
          aria-label={fillWords(text.bricks.ownedOf, { name })}
          value={owned[id] ?? ''}
          onChange={(event) => setOwned(event.currentTarget.value)}
        />
      </label>
    </li>
  );
}

/** A picture of one part; an empty frame until it is drawn, and without WebGL. */
export function PartPicture({ id }: { readonly id: string }) {
  const { partPicture } = usePage();
  const [address, setAddress] = useState<string | null>(null);
  useEffect(() => {
    let here = true;
    partPicture(id).then(
      (made) => here && setAddress(made),
      () => undefined,
    );
    return () => {
      here = false;
    };
  }, [id, partPicture]);
  return (
    <span class="part-picture">
      {address ? <img src={address} alt="" width="160" height="112" /> : null}
    </span>
  );
}
