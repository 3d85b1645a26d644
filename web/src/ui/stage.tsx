import { useEffect, useRef, useState } from 'preact/hooks';
import { CommandButton } from './controls.tsx';
import { FirstSteps } from './first-steps.tsx';
import { Icon } from './icon.tsx';
import { JointCard } from './joint-card.tsx';
import { OffsetCard } from './offset-card.tsx';
import { usePage } from './page-context.ts';
import { PartCard } from './part-card.tsx';
import { findRoom } from './rooms/room-table.ts';
import { text } from './text.ts';
import { ToolOptions } from './tool-options.tsx';
import { LineCard } from './touch/line-card.tsx';
import { ViewBar } from './view-bar.tsx';

/** The drawing with what floats over it. */
export function Stage() {
  const page = usePage();
  const host = useRef<HTMLDivElement>(null);
  // Behind a room that the page opens with, as a lesson by its link, nothing is drawn that nobody sees.
  const uncovered = findRoom(page.room.value) === null;
  const [wanted, setWanted] = useState(uncovered);
  useEffect(() => {
    if (uncovered) {
      setWanted(true);
    }
  }, [uncovered]);
  useEffect(
    () => (wanted && host.current ? page.mountScene(host.current) : undefined),
    [page, wanted],
  );
  return (
    <main class="stage" aria-label={text.app.drawing}>
      <div ref={host} class="scene" />
      {page.webglMissing.value ? (
        <p class="note bad no-webgl" role="alert">
          {text.app.noWebgl}
        </p>
      ) : null}
      <SelectionBox />
      <div class="stage-top">
        <ToolOptions />
        <OffsetCard />
        <JointCard />
        <Invitation />
        <FirstSteps />
        <Hint />
      </div>
      <PartCard />
      <LineCard />
      <ViewBar />
      {page.dropping.value ? (
        <div class="drop-veil">
          <Icon name="open" />
          {text.files.drop}
        </div>
      ) : null}
      <p class="visually-hidden" id="drawing-help">
        {text.app.drawingHelp}
      </p>
      <p class="visually-hidden" aria-live="polite" data-testid="announcer">
        {page.announcement.value}
      </p>
    </main>
  );
}

/** Over somebody else's sketch: the way to one's own. */
function Invitation() {
  const page = usePage();
  if (!page.lookedAt.value || page.tool.value.id !== 'select') {
    return null;
  }
  return (
    <p class="invitation floating">
      <span>{text.hints.example}</span>
      <CommandButton id="new" words={text.hints.drawOwn} class="primary small" />
    </p>
  );
}

function Hint() {
  const page = usePage();
  const empty = page.store.sketch.value.lines.length === 0;
  const tool = page.tool.value;
  const { lock } = tool.overlay.value;
  const part = page.hoveredPart.value;
  const row = part === null ? undefined : page.result.value?.rows.find((r) => r.part === part);
  const hint = empty && tool.id === 'select' ? text.hints.empty : tool.hint.value;
  if (page.lookedAt.value && tool.id === 'select' && !row) {
    return null;
  }
  if (row) {
    return (
      <p class="hint floating">
        <strong>{row.name}</strong>
        <span>{row.part}</span>
        <span>{row.count}×</span>
      </p>
    );
  }
  return (
    <p class="hint floating">
      {lock ? <span class={`lock axis-${lock}`}>{lock.toUpperCase()}</span> : null}
      <span>{hint}</span>
    </p>
  );
}

function SelectionBox() {
  const { box } = usePage().tool.value.overlay.value;
  if (!box) {
    return null;
  }
  const left = Math.min(box.from.x, box.to.x);
  const top = Math.min(box.from.y, box.to.y);
  const width = Math.abs(box.to.x - box.from.x);
  const height = Math.abs(box.to.y - box.from.y);
  return (
    <div
      class="selection-box"
      style={{ left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` }}
    />
  );
}
