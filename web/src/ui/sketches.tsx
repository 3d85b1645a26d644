import { useEffect, useState } from 'preact/hooks';
import type { LibraryEntry } from '../state/library.ts';
import { fillWords } from '../tools/tool-words.ts';
import { CommandButton } from './controls.tsx';
import { Dialog } from './dialog.tsx';
import { Icon } from './icon.tsx';
import { usePage } from './page-context.ts';
import { SketchPicture } from './sketch-picture.tsx';
import { language } from './text/language.ts';
import { plural, text } from './text.ts';

/** The sketches that this browser keeps: to open, to copy, to delete. */
export function Sketches() {
  const { sketches, dialog } = usePage();
  const [list, setList] = useState<readonly LibraryEntry[] | null>(null);
  const load = () => {
    sketches.list().then(setList, () => setList([]));
  };
  useEffect(load, []);
  const change = (done: Promise<void>) => {
    done.then(load, load);
  };
  return (
    <Dialog title={text.sketches.title} class="examples sketches">
      <div class="dialog-bar">
        <p class="quiet">{text.sketches.text}</p>
        <CommandButton id="new" words={text.sketches.create} class="secondary" />
        <CommandButton id="open" words={text.sketches.import} class="secondary" />
      </div>
      {list === null ? <p>{text.app.loading}</p> : null}
      {list?.length === 0 ? <p>{text.sketches.none}</p> : null}
      <ul class="example-grid">
        {list?.map((entry) => (
          <SketchCard
            key={entry.id}
            entry={entry}
            onOpen={() => {
              dialog.value = null;
              sketches.open(entry.id);
            }}
            onDuplicate={() => change(sketches.duplicate(entry.id))}
            onRemove={() => change(sketches.remove(entry.id))}
          />
        ))}
      </ul>
    </Dialog>
  );
}

const DATES = new Intl.DateTimeFormat(language, { dateStyle: 'medium', timeStyle: 'short' });

function SketchCard(props: {
  readonly entry: LibraryEntry;
  readonly onOpen: () => void;
  readonly onDuplicate: () => void;
  readonly onRemove: () => void;
}) {
  const { sketch, changed, id } = props.entry;
  const isOpen = usePage().sketches.openId() === id;
  const name = sketch.name || text.app.untitled;
  return (
    <li class="sketch-card" aria-current={isOpen ? 'true' : undefined}>
      <button type="button" class="example" onClick={props.onOpen}>
        <SketchPicture sketch={sketch} />
        <strong>{name}</strong>
        <span class="quiet">
          {plural(sketch.lines.length, 'line')}
          {changed > 0 ? ` · ${DATES.format(changed)}` : ''}
        </span>
      </button>
      <div class="card-actions">
        <button
          type="button"
          class="icon-button"
          title={text.commands.duplicate}
          aria-label={fillWords(text.sketches.duplicate, { name })}
          onClick={props.onDuplicate}
        >
          <Icon name="copy" />
        </button>
        {isOpen ? null : <RemoveButton name={name} onRemove={props.onRemove} />}
      </div>
    </li>
  );
}

/** Asks once more in place before a sketch is gone for good. */
function RemoveButton({
  name,
  onRemove,
}: {
  readonly name: string;
  readonly onRemove: () => void;
}) {
  const [asked, setAsked] = useState(false);
  const label = fillWords(asked ? text.sketches.reallyRemove : text.sketches.remove, { name });
  return (
    <button
      type="button"
      class={asked ? 'button danger' : 'icon-button'}
      title={label}
      aria-label={label}
      onClick={() => (asked ? onRemove() : setAsked(true))}
      onBlur={() => setAsked(false)}
    >
      <Icon name="trash" />
      {asked ? <span>{text.sketches.confirm}</span> : null}
    </button>
  );
}
