import { Icon } from './icon.tsx';
import { usePage } from './page-context.ts';
import { nameOfPlace, PLACES, type Place, placeOf } from './places.ts';
import { text } from './text.ts';

/** The places of the page by their names, always in sight: above on a wide page, below on a phone. */
export function Spine() {
  return (
    <nav class="spine" aria-label={text.places.title}>
      <ul>
        {PLACES.map((place) => (
          <SpineLink key={place.id} place={place} />
        ))}
      </ul>
    </nav>
  );
}

function SpineLink({ place }: { readonly place: Place }) {
  const page = usePage();
  const { id, icon } = place;
  const here = placeOf(page.room.value) === id;
  const name = nameOfPlace(id);
  return (
    <li>
      <a
        href={name === null ? './' : `?room=${name}`}
        aria-current={here ? 'page' : undefined}
        title={text.places.about[id]}
        onClick={(event) => {
          // With a key held, the browser's own: another tab or window.
          if (!event.ctrlKey && !event.metaKey && !event.shiftKey) {
            event.preventDefault();
            page.openRoom(name);
          }
        }}
      >
        <Icon name={icon} />
        <span>{text.places.names[id]}</span>
      </a>
    </li>
  );
}
