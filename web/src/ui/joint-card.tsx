import { AXIS_NAMES, unitVector } from '../geometry/vec.ts';
import { bodyColour } from '../model/line-bodies.ts';
import type { SketchDocument, SketchJoint } from '../model/sketch.ts';
import {
  axisNameOf,
  bodiesOf,
  dropJoint,
  furtherJoint,
  insertJoint,
  jointIndex,
  jointsAt,
  legalRange,
  linesAlong,
  linesAt,
  moveLine,
  placeOfJoint,
  replaceJoint,
  withRange,
} from '../state/joint-edits.ts';
import { fillWords } from '../tools/tool-words.ts';
import { IconButton } from './controls.tsx';
import { Icon } from './icon.tsx';
import type { Page } from './page.ts';
import { usePage } from './page-context.ts';
import { formatPoint } from './text/language.ts';
import { inWords } from './text/sentences.ts';
import { text } from './text.ts';
import './joint-card.css';
import './number-field.css';

const words = text.joint;

interface Shown {
  readonly page: Page;
  readonly sketch: SketchDocument;
  readonly index: number;
  readonly joint: SketchJoint;
}

/** The joint that is being changed: its axis, what moves, how far it must turn. */
export function JointCard() {
  const page = usePage();
  const sketch = page.store.sketch.value;
  const index = page.tool.value.id === 'joint' ? jointIndex(sketch, page.joint.value) : null;
  const joint = index === null ? undefined : sketch.joints?.[index];
  if (index === null || !joint) {
    return null;
  }
  const shown = { page, sketch, index, joint };
  return (
    <section class="joint-card floating" aria-label={fillWords(words.title, { n: index + 1 })}>
      <Head {...shown} />
      <Axis {...shown} />
      <Lines {...shown} />
      <Range {...shown} />
      <Refusal page={page} />
    </section>
  );
}

function change({ page, sketch, index, joint }: Shown, next: SketchJoint): void {
  if (JSON.stringify(next) !== JSON.stringify(joint)) {
    page.store.commit(text.edits.joint, replaceJoint(sketch, index, next));
  }
}

function Head(shown: Shown) {
  const { page, sketch, index, joint } = shown;
  const there = jointsAt(sketch, joint.at);
  const nth = there.indexOf(index);
  const add = () => {
    const more = furtherJoint(sketch, joint.at);
    if (more) {
      const next = insertJoint(sketch, more);
      page.store.commit(text.edits.joint, next);
      page.joint.value = placeOfJoint(next, (next.joints?.length ?? 1) - 1);
    }
  };
  return (
    <header>
      <h2>{fillWords(words.title, { n: index + 1 })}</h2>
      <span class="quiet">{formatPoint(joint.at)}</span>
      {there.length > 1 ? (
        <button
          type="button"
          class="button plain small"
          onClick={() => {
            page.joint.value = { at: joint.at, nth: (nth + 1) % there.length };
          }}
        >
          {fillWords(words.ofThere, { k: nth + 1, n: there.length })}
        </button>
      ) : null}
      <IconButton icon="plus" label={words.another} onClick={add} />
      <IconButton
        icon="trash"
        label={words.remove}
        onClick={() => {
          page.store.commit(text.edits.joint, dropJoint(sketch, index));
          page.focusDrawing();
        }}
      />
      <IconButton
        icon="close"
        label={words.close}
        onClick={() => {
          page.joint.value = null;
          page.focusDrawing();
        }}
      />
    </header>
  );
}

function Axis(shown: Shown) {
  const { sketch, joint } = shown;
  const now = axisNameOf(joint);
  return (
    <fieldset class="joint-row">
      <legend class="visually-hidden">{words.axisOf}</legend>
      <span class="joint-word" aria-hidden="true">
        {words.axisOf}
      </span>
      {AXIS_NAMES.map((name) => {
        const along = linesAlong(sketch, joint.at, name);
        const about =
          along.length > 0
            ? fillWords(words.itself, { lines: along.map((i) => i + 1).join(', ') })
            : '';
        return (
          <button
            key={name}
            type="button"
            class={`button axis-${name}`}
            aria-label={`${name.toUpperCase()}${about ? `, ${about}` : ''}`}
            title={about}
            aria-pressed={now === name}
            onClick={() => change(shown, { ...joint, axis: unitVector(name) })}
          >
            {name.toUpperCase()}
            {about ? <Icon name="axis" /> : null}
          </button>
        );
      })}
    </fieldset>
  );
}

function Lines(shown: Shown) {
  const { sketch, joint } = shown;
  const bodies = bodiesOf(sketch, joint);
  return (
    <fieldset class="joint-row">
      <legend class="visually-hidden">{words.moves}</legend>
      <span class="joint-word" aria-hidden="true">
        {words.moves}
      </span>
      {linesAt(sketch, joint.at).map((line) => {
        const body = bodies.findIndex((lines) => lines.includes(line));
        const says = body < 0 ? words.noBody : fillWords(words.body, { n: body + 1 });
        return (
          <button
            key={line}
            type="button"
            class="button joint-line"
            aria-label={`${fillWords(words.line, { n: line + 1 })}: ${says}. ${words.change}`}
            title={words.change}
            onClick={() => change(shown, moveLine(sketch, joint, line))}
          >
            <span
              class="joint-body"
              style={body < 0 ? {} : { background: cssColour(bodyColour(body)) }}
            />
            <span>{fillWords(words.line, { n: line + 1 })}</span>
            <b>{body < 0 ? '–' : body + 1}</b>
          </button>
        );
      })}
    </fieldset>
  );
}

function Range(shown: Shown) {
  const { joint } = shown;
  const [from, to] = joint.range ?? [0, 0];
  const full = from === -180 && to === 180;
  const ask = (low: number, high: number) =>
    change(shown, withRange(joint, legalRange(low || 0, high || 0)));
  return (
    <fieldset class="joint-row">
      <legend class="visually-hidden">{words.range}</legend>
      <span class="joint-word" aria-hidden="true">
        {words.mustTurn}
      </span>
      <Degrees label={words.from} value={from} onValue={(value) => ask(-Math.abs(value), to)} />
      <span aria-hidden="true">–</span>
      <Degrees label={words.to} value={to} onValue={(value) => ask(from, value)} />
      <button
        type="button"
        class="button"
        aria-pressed={full}
        onClick={() => change(shown, withRange(joint, full ? null : [-180, 180]))}
      >
        {words.fullTurn}
      </button>
      {joint.range && !full ? (
        <IconButton
          icon="close"
          label={words.noRange}
          onClick={() => change(shown, withRange(joint, null))}
        />
      ) : null}
    </fieldset>
  );
}

function Degrees(props: {
  readonly label: string;
  readonly value: number;
  readonly onValue: (value: number) => void;
}) {
  return (
    <label class="joint-degrees">
      <span class="visually-hidden">{props.label}</span>
      <input
        type="number"
        min="-180"
        max="180"
        step="5"
        value={props.value}
        onChange={(event) => props.onValue(event.currentTarget.valueAsNumber)}
      />
      <span aria-hidden="true">°</span>
    </label>
  );
}

function Refusal({ page }: { readonly page: Page }) {
  const reason = page.jointRefusal.value;
  return (
    <p class={reason ? 'joint-refusal' : 'visually-hidden'} role="alert">
      {reason ? (
        <>
          <Icon name="alert" />
          <span>{inWords(reason)}</span>
        </>
      ) : null}
    </p>
  );
}

function cssColour(colour: number): string {
  return `#${colour.toString(16).padStart(6, '0')}`;
}
