import type { ComponentType } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { CommandButton } from '../controls.tsx';
import { Icon } from '../icon.tsx';
import { usePage } from '../page-context.ts';
import { text } from '../text.ts';
import type { Room, RoomProps } from './room.ts';

type Loaded = { readonly component: ComponentType<RoomProps> } | 'loading' | 'failed';

/** The room that is open, over the whole page. The drawing waits underneath as it was. */
export function RoomHost({ room }: { readonly room: Room }) {
  const page = usePage();
  const heading = useRef<HTMLHeadingElement>(null);
  const [loaded, setLoaded] = useState<Loaded>('loading');
  useEffect(() => {
    let open = true;
    setLoaded('loading');
    heading.current?.focus();
    room.load().then(
      (component) => open && setLoaded({ component }),
      () => open && setLoaded('failed'),
    );
    return () => {
      open = false;
    };
  }, [room]);
  const close = () => page.openRoom(null);
  return (
    <section class="room" aria-labelledby="room-title">
      <header class="room-head">
        <button type="button" class="button plain" onClick={close}>
          <Icon name="back" />
          <span>{text.rooms.back}</span>
        </button>
        <h2 id="room-title" ref={heading} tabIndex={-1}>
          {room.title}
        </h2>
        <CommandButton id="themeNext" class="room-theme narrow-only" />
      </header>
      <div class="room-body">
        {loaded === 'loading' ? <p class="quiet">{text.app.loading}</p> : null}
        {loaded === 'failed' ? <p role="alert">{text.rooms.failed}</p> : null}
        {typeof loaded === 'object' ? <loaded.component close={close} /> : null}
      </div>
    </section>
  );
}
