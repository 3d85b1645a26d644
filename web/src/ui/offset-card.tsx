import { useEffect, useRef, useState } from 'preact/hooks';
import { AXIS_NAMES, type AxisName } from '../geometry/vec.ts';
import { mirrorPlace } from '../state/mirror-place.ts';
import {
  isOffset,
  MAX_COPIES,
  MAX_OFFSET,
  type Offset,
  offsetImages,
  offsetLines,
} from '../state/offset-lines.ts';
import { IconButton, Segmented } from './controls.tsx';
import type { Page } from './page.ts';
import { usePage } from './page-context.ts';
import { text } from './text.ts';
import './offset-card.css';
import './number-field.css';

const words = text.offset;

/** What stands in the fields; an empty one is 0. */
interface Typed {
  readonly kind: Offset['kind'];
  readonly by: Readonly<Record<AxisName, string>>;
  readonly count: string;
  readonly axis: AxisName;
  /** Null: where a mirror is most likely meant. */
  readonly at: string | null;
}

const NOTHING: Typed = {
  kind: 'move',
  by: { x: '', y: '', z: '' },
  count: '1',
  axis: 'x',
  at: null,
};

/** Moves, copies or mirrors the selected lines by numbers; the drawing shows where they would lie. */
export function OffsetCard() {
  const page = usePage();
  const { store, tool, offsetOpen } = page;
  const open = offsetOpen.value && tool.value.id === 'select' && store.selection.value.size > 0;
  return open ? <Card page={page} /> : null;
}

function Card({ page }: { readonly page: Page }) {
  const { store, ghostLines, offsetOpen } = page;
  const [typed, setTyped] = useState(NOTHING);
  const form = useRef<HTMLFormElement>(null);
  const [sketch, selection] = [store.sketch.value, store.selection.value];
  const offset = offsetOf(typed, mirrorPlace(sketch, selection, typed.axis));
  const legal = isOffset(offset);
  const told = JSON.stringify(offset);
  useEffect(() => {
    const meant = JSON.parse(told) as Offset;
    ghostLines.value = isOffset(meant) ? offsetImages(sketch, selection, meant) : [];
    return () => {
      ghostLines.value = [];
    };
  }, [ghostLines, sketch, selection, told]);
  useEffect(() => form.current?.querySelector<HTMLElement>('input[type=number]')?.focus(), []);
  const apply = (event: Event) => {
    event.preventDefault();
    if (legal) {
      const { sketch: next } = offsetLines(sketch, selection, offset);
      store.commit(text.edits[EDITS[offset.kind]], next);
      page.announce(text.edits[EDITS[offset.kind]]);
    }
  };
  return (
    <section class="offset-card floating" aria-label={words.title}>
      <form ref={form} onSubmit={apply}>
        <header>
          <Segmented
            name="offset-kind"
            legend={words.title}
            choices={KINDS}
            value={typed.kind}
            onChange={(kind) => setTyped({ ...typed, kind })}
          />
          <IconButton
            icon="close"
            class="small"
            label={text.app.close}
            onClick={() => {
              offsetOpen.value = false;
              page.focusDrawing();
            }}
          />
        </header>
        <div class="offset-fields">
          {typed.kind === 'mirror' ? (
            <MirrorFields typed={typed} offset={offset} onChange={setTyped} />
          ) : (
            <VectorFields typed={typed} onChange={setTyped} />
          )}
          <button type="submit" class="button primary small" disabled={!legal}>
            {words.apply[typed.kind]}
          </button>
        </div>
      </form>
    </section>
  );
}

const KINDS = (['move', 'copies', 'mirror'] as const).map((value) => ({
  value,
  label: words.kinds[value],
}));

const EDITS = { move: 'move', copies: 'array', mirror: 'mirror' } as const;

function offsetOf({ kind, by, count, axis, at }: Typed, usual: number): Offset {
  if (kind === 'mirror') {
    return { kind, axis, at: at === null ? usual : Number(at) };
  }
  const vector = [Number(by.x), Number(by.y), Number(by.z)] as const;
  return kind === 'move' ? { kind, by: vector } : { kind, by: vector, count: Number(count) };
}

interface FieldsProps {
  readonly typed: Typed;
  readonly onChange: (typed: Typed) => void;
}

function VectorFields({ typed, onChange }: FieldsProps) {
  return (
    <>
      {AXIS_NAMES.map((axis) => (
        <NumberField
          key={axis}
          label={axis.toUpperCase()}
          class={`axis-${axis}`}
          value={typed.by[axis]}
          onInput={(value) => onChange({ ...typed, by: { ...typed.by, [axis]: value } })}
        />
      ))}
      {typed.kind === 'copies' ? (
        <NumberField
          label="×"
          name={words.count}
          min={1}
          max={MAX_COPIES}
          value={typed.count}
          onInput={(count) => onChange({ ...typed, count })}
        />
      ) : null}
    </>
  );
}

function MirrorFields({ typed, offset, onChange }: FieldsProps & { readonly offset: Offset }) {
  const axis = typed.axis.toUpperCase();
  return (
    <>
      <Segmented
        name="offset-axis"
        legend={words.across}
        choices={AXIS_NAMES.map((value) => ({ value, label: value.toUpperCase() }))}
        value={typed.axis}
        onChange={(value) => onChange({ ...typed, axis: value, at: null })}
      />
      <NumberField
        label={`${axis} =`}
        step={0.5}
        value={typed.at ?? (offset.kind === 'mirror' ? String(offset.at) : '')}
        onInput={(at) => onChange({ ...typed, at })}
      />
    </>
  );
}

function NumberField(props: {
  readonly label: string;
  /** What it is called, where the label is a sign. */
  readonly name?: string;
  readonly class?: string;
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
  readonly value: string;
  readonly onInput: (value: string) => void;
}) {
  return (
    <label>
      <span class={props.class}>{props.label}</span>
      <input
        type="number"
        min={props.min ?? -MAX_OFFSET}
        max={props.max ?? MAX_OFFSET}
        step={props.step ?? 1}
        placeholder="0"
        aria-label={props.name}
        value={props.value}
        onInput={(event) => props.onInput(event.currentTarget.value)}
      />
    </label>
  );
}
