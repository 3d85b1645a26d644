import { useEffect, useRef, useState } from 'preact/hooks';
import type { BuildStep } from '../../instructions/build-steps.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { Icon } from '../icon.tsx';
import { text } from '../text.ts';
import type { Book } from './book.ts';
import { instructionWords as words } from './instruction-words.ts';
import { ApartTile, PartTile } from './part-tile.tsx';
import { StepCanvas } from './step-canvas.tsx';
import { notesOf, type StepNotes } from './step-notes.ts';
import { modelKey, readTicks, writeTicks } from './ticks.ts';

const SWIPE = 50;

function storage(): Storage | null {
  try {
    return window.localStorage;
  } catch {
    return null;
  }
}

interface Reading {
  readonly index: number;
  readonly ticks: ReadonlySet<number>;
  readonly go: (index: number) => void;
  readonly tick: (index: number) => void;
}

/** Where the reader is, and what is done. */
function useReading(book: Book, json: string): Reading {
  const key = modelKey(json, book.most);
  const [ticks, setTicks] = useState(() => readTicks(key, storage()));
  const last = book.steps.length - 1;
  const [index, setIndex] = useState(() => {
    const open = book.steps.findIndex((_, i) => !ticks.has(i));
    return open < 0 ? 0 : open;
  });
  const go = (next: number) => setIndex(Math.min(last, Math.max(0, next)));
  const tick = (at: number) => {
    const next = new Set(ticks);
    if (next.has(at)) {
      next.delete(at);
    } else {
      next.add(at);
      go(at + 1);
    }
    writeTicks(key, next, storage());
    setTicks(next);
  };
  return { index, ticks, go, tick };
}

/** One step at a time: what to take, where it goes, what is done. */
export function StepsView({ book, json }: { readonly book: Book; readonly json: string }) {
  const reading = useReading(book, json);
  const { index, go, tick } = reading;
  const start = useRef<number | null>(null);
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      const target = event.target instanceof HTMLElement ? event.target : null;
      if (target?.closest('input, textarea, select, [role="tablist"]')) {
        return;
      }
      const action = keyAction(event.key, book.steps.length, reading);
      if (action && !(event.key === ' ' && target?.closest('button'))) {
        event.preventDefault();
        action();
      }
    };
    window.addEventListener('keydown', onKey);
    return () => window.removeEventListener('keydown', onKey);
  });
  const step = book.steps[index];
  if (!step) {
    return <p role="alert">{text.places.needsModel}</p>;
  }
  return (
    <div
      class="step-view"
      onPointerDown={(event) => {
        start.current = event.clientX;
      }}
      onPointerUp={(event) => {
        const moved = start.current === null ? 0 : event.clientX - start.current;
        start.current = null;
        if (Math.abs(moved) > SWIPE) {
          go(index + (moved < 0 ? 1 : -1));
        }
      }}
    >
      <StepHead book={book} step={step} index={index} />
      <StepCanvas book={book} index={index} />
      <StepFoot book={book} reading={reading} tick={() => tick(index)} />
    </div>
  );
}

function keyAction(key: string, count: number, reading: Reading): (() => void) | null {
  const { index, go, tick } = reading;
  switch (key) {
    case 'ArrowRight':
    case 'PageDown':
      return () => go(index + 1);
    case 'ArrowLeft':
    case 'PageUp':
      return () => go(index - 1);
    case 'Home':
      return () => go(0);
    case 'End':
      return () => go(count - 1);
    case ' ':
      return () => tick(index);
    default:
      return null;
  }
}

function StepHead(props: {
  readonly book: Book;
  readonly step: BuildStep;
  readonly index: number;
}) {
  const { book, step, index } = props;
  const notes = notesOf(book, index);
  const [apart, ...more] = notes.apart;
  return (
    <div class="step-head">
      <div class="step-number" aria-live="polite">
        <strong>{step.number}</strong>
        <span class="quiet">
          {fillWords(words.step, { n: step.number, all: book.steps.length })}
        </span>
      </div>
      {apart ? (
        <p class="step-apart" data-testid="apart">
          {apart}
          {more.map((note) => (
            <strong key={note}>{note}</strong>
          ))}
        </p>
      ) : null}
      <ul class="parts-box" aria-label={words.box}>
        {step.loose.map((row) => (
          <PartTile key={`${row.part}/${row.color}`} row={row} shelf={book.shelf} />
        ))}
        {step.putIns.map((put) => (
          <ApartTile key={put.group} book={book} index={index} put={put} />
        ))}
      </ul>
      <Notes notes={notes} />
    </div>
  );
}

function Notes({ notes }: { readonly notes: StepNotes }) {
  const { turned, warnings } = notes;
  return turned || warnings.length > 0 ? (
    <ul class="step-notes">
      {turned ? (
        <li>
          <Icon name="rotate" />
          {turned}
        </li>
      ) : null}
      {warnings.map((note) => (
        <li key={note}>
          <Icon name="alert" />
          {note}
        </li>
      ))}
    </ul>
  ) : null;
}

function StepFoot(props: {
  readonly book: Book;
  readonly reading: Reading;
  readonly tick: () => void;
}) {
  const { book, reading, tick } = props;
  const { index, ticks, go } = reading;
  const all = book.steps.length;
  return (
    <div class="step-foot">
      <button
        type="button"
        class="button step-go"
        disabled={index === 0}
        onClick={() => go(index - 1)}
      >
        ‹ <span>{words.previous}</span>
      </button>
      <div class="step-progress">
        <progress value={ticks.size} max={all} aria-label={words.done} />
        <span class="quiet">{fillWords(words.progress, { n: ticks.size, all })}</span>
      </div>
      <label class="step-tick">
        <input type="checkbox" checked={ticks.has(index)} onChange={tick} />
        <span>{words.done}</span>
      </label>
      <button
        type="button"
        class="button primary step-go"
        disabled={index === all - 1}
        onClick={() => go(index + 1)}
      >
        <span>{words.next}</span> ›
      </button>
      <p class="quiet step-keys">{words.keys}</p>
    </div>
  );
}
