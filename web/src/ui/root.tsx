import { About } from './about.tsx';
import { AlternativesSheet } from './alternatives-sheet.tsx';
import { BrickSet } from './brick-set.tsx';
import { Examples } from './examples.tsx';
import { Help } from './help.tsx';
import { LegalSheet } from './legal-sheet.tsx';
import { Menu } from './menu.tsx';
import type { Page } from './page.ts';
import { PageProvider, usePage } from './page-context.ts';
import { Palette } from './palette.tsx';
import { Panel } from './panel.tsx';
import { placeOf } from './places.ts';
import { RoomHost } from './rooms/room-host.tsx';
import { findRoom } from './rooms/room-table.ts';
import { Sketches } from './sketches.tsx';
import { Stage } from './stage.tsx';
import { text } from './text.ts';
import { Toasts } from './toasts.tsx';
import { ToolRail } from './tool-rail.tsx';
import { TopBar } from './top-bar.tsx';

/** The whole page. */
export function Root({ page }: { readonly page: Page }) {
  return (
    <PageProvider value={page}>
      <Skip />
      <TopBar />
      <Editor />
      <Rooms />
      <Toasts />
      <Dialogs />
    </PageProvider>
  );
}

function Skip() {
  const page = usePage();
  const toDrawing = () => {
    page.openRoom(null);
    page.focusDrawing();
  };
  return (
    <button type="button" class="skip" onClick={toDrawing}>
      {text.app.skip}
    </button>
  );
}

/** The drawing with its tools and its panel; it waits while a room is open. */
function Editor() {
  const { room } = usePage();
  const waiting = findRoom(room.value) !== null;
  return (
    <div class="editor work" inert={waiting} data-place={placeOf(room.value)}>
      <ToolRail />
      <Stage />
      <Panel />
    </div>
  );
}

function Rooms() {
  const room = findRoom(usePage().room.value);
  return room ? <RoomHost room={room} /> : null;
}

function Dialogs() {
  switch (usePage().dialog.value) {
    case 'menu':
      return <Menu />;
    case 'palette':
      return <Palette />;
    case 'help':
      return <Help />;
    case 'examples':
      return <Examples />;
    case 'sketches':
      return <Sketches />;
    case 'alternatives':
      return <AlternativesSheet />;
    case 'bricks':
      return <BrickSet />;
    case 'legal':
      return <LegalSheet />;
    case 'about':
      return <About />;
    case null:
      return null;
  }
}
