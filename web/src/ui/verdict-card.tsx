import type { RefObject } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import type { Lamp, LampState } from '../model/verdict.ts';
import { connectedLines } from '../state/connectivity.ts';
import { freeLine } from '../state/keeps.ts';
import { hasMend, isLoud } from '../state/sketch-faults.ts';
import { fillWords } from '../tools/tool-words.ts';
import { CommandButton } from './controls.tsx';
import { mendWords } from './fault-words.ts';
import { Icon, type IconName } from './icon.tsx';
import type { Page } from './page.ts';
import { usePage } from './page-context.ts';
import { placeOf } from './places.ts';
import { text } from './text.ts';
import { touchWords } from './touch/touch-words.ts';
import { type CardState, cardState } from './verdict-state.ts';

/** Colour is never alone: each state has a shape of its own. */
const SHAPES: Readonly<Record<LampState, IconName>> = {
  ok: 'check',
  warn: 'alert',
  bad: 'close',
  none: 'minus',
  busy: 'rotate',
};

/** The one verdict, what is wrong first and its mend, and the lamps. It keeps its place and its height. */
export function VerdictCard() {
  const page = usePage();
  const card = cardState(page);
  const { phase, message } = page.solve.value;
  const loud = phase === 'refused' || phase === 'failed';
  const frame = useKeptHeight(phase === 'solving' || page.stale.value);
  return (
    <section ref={frame} class={`verdict-card ${card.tone}`} aria-label={text.solve.title}>
      <div
        class="verdict"
        role={loud ? 'alert' : 'status'}
        data-testid={card.final ? 'verdict' : undefined}
      >
        <Icon name={SHAPES[card.tone]} />
        <strong>{card.title}</strong>
        <p>{card.words}</p>
      </div>
      {phase === 'solving' ? <Progress /> : null}
      {phase === 'cancelled' ? <p class="quiet">{message}</p> : null}
      <Ways card={card} />
      <Lamps lamps={card.lamps} />
    </section>
  );
}

/** While a model is coming, the card stays as high as it was: what stands below it does not jump. */
function useKeptHeight(keep: boolean): RefObject<HTMLElement | null> {
  const frame = useRef<HTMLElement>(null);
  const known = useRef(0);
  useLayoutEffect(() => {
    const element = frame.current;
    if (!element) {
      return;
    }
    if (keep) {
      element.style.minHeight = known.current > 0 ? `${known.current}px` : '';
    } else {
      element.style.minHeight = '';
      known.current = element.offsetHeight;
    }
  });
  return frame;
}

/** What can be done about what is wrong first. */
function Ways({ card }: { readonly card: CardState }) {
  const page = usePage();
  const { first } = card;
  const fault = page.faults.value.find(isLoud);
  if (first === null) {
    return null;
  }
  const more =
    first.kind === 'fault' ? page.faults.value.filter(isLoud).length : manyProblems(page);
  const show = placeToShow(page, card);
  const inCheck = placeOf(page.room.value) === 'check';
  return (
    <div class="mends">
      {first.kind === 'fault' && fault && hasMend(fault) ? (
        <button type="button" class="button primary small" onClick={() => page.mend(fault)}>
          {mendWords(fault)}
        </button>
      ) : null}
      {first.kind === 'problem' && first.problem.line !== undefined ? (
        <ReleaseLine line={first.problem.line} />
      ) : null}
      {(first.kind === 'problem' || first.kind === 'item') && ofSearch(page) ? (
        <CommandButton id="newSeed" words={text.result.trySeed} class="small" />
      ) : null}
      {first.kind === 'problem' && !ofSearch(page) ? (
        <button type="button" class="button primary small" onClick={page.mendModel}>
          {text.mends.look}
        </button>
      ) : null}
      {show ? (
        <button type="button" class="button small" onClick={show}>
          {text.verdict.show}
        </button>
      ) : null}
      {inCheck ? null : (
        <button type="button" class="button plain small" onClick={() => page.openRoom('check')}>
          {more > 1 ? fillWords(text.verdict.all, { n: more }) : text.verdict.see}
        </button>
      )}
    </div>
  );
}

/** Keeps nothing on a line any more, where what is kept there cannot be. */
function ReleaseLine({ line }: { readonly line: number }) {
  const page = usePage();
  const label = touchWords.edits.free;
  const release = () =>
    page.touchModel({
      label,
      next: freeLine(page.store.sketch.value, line),
      index: null,
      place: null,
    });
  return (
    <button type="button" class="button primary small" onClick={release}>
      {label}
    </button>
  );
}

/** A model from a file is not searched for again. */
function ofSearch({ result }: Page): boolean {
  return result.value?.source === 'search';
}

function manyProblems({ result }: Page): number {
  return result.value?.problems.length ?? 0;
}

/** What lights the place of what is wrong first; null where it has none. */
function placeToShow(page: Page, { first }: CardState): (() => void) | null {
  const fault = page.faults.value.find(isLoud);
  switch (first?.kind) {
    case 'fault':
      return fault ? () => page.showPlace(fault.at) : null;
    case 'problem':
      return () => page.focusProblem(first.index);
    case 'pieces':
      return () => selectLesserPiece(page);
    case 'wellBuilt': {
      const at = first.item.places?.[0]?.at;
      return at ? () => page.showPlace(at) : null;
    }
    default:
      return null;
  }
}

/** Selects the lines that do not hang together with the most of the others. */
function selectLesserPiece({ store }: Page): void {
  const sketch = store.sketch.value;
  const pieces: ReadonlySet<number>[] = [];
  for (const index of sketch.lines.keys()) {
    if (!pieces.some((piece) => piece.has(index))) {
      pieces.push(connectedLines(sketch, new Set([index])));
    }
  }
  const most = pieces.reduce((a, b) => (b.size > a.size ? b : a), new Set<number>());
  store.select([...sketch.lines.keys()].filter((index) => !most.has(index)));
}

function Progress() {
  const { progress } = usePage().solve.value;
  return <progress max="1" value={progress?.fraction ?? 0} aria-label={text.verdict.solving} />;
}

function Lamps({ lamps }: { readonly lamps: readonly Lamp[] }) {
  return (
    <ul class="lamps">
      {lamps.map((lamp) => (
        <LampButton key={lamp.id} lamp={lamp} />
      ))}
    </ul>
  );
}

/** A lamp leads to where its matter is looked into. */
function LampButton({ lamp }: { readonly lamp: Lamp }) {
  const page = usePage();
  const name = text.verdict.lamps[lamp.id];
  const state = text.verdict.states[lamp.state];
  return (
    <li>
      <button
        type="button"
        class={`lamp ${lamp.state}`}
        title={`${name}: ${state}`}
        onClick={() => page.openRoom(lamp.id === 'moves' ? 'move' : 'check')}
      >
        <span class="bulb">
          <Icon name={SHAPES[lamp.state]} />
        </span>
        <span>{name}</span>
        <span class="visually-hidden">: {state}</span>
      </button>
    </li>
  );
}
