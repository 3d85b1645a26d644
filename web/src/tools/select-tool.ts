import { type ReadonlySignal, signal } from '@preact/signals';
import { AXIS_NAMES, add, scale, subtract, unitVector, type Vec3 } from '../geometry/vec.ts';
import type { SketchDocument } from '../model/sketch.ts';
import { pointKey } from '../model/sketch.ts';
import { chainedLines } from '../state/connectivity.ts';
import { mapLines, shift } from '../state/edits.ts';
import { stretch, tearOff } from '../state/stretch.ts';
import type { GuidePlane, Navigation, ScreenPoint } from '../view/view-types.ts';
import { meetGuide, planeAxes, planeAxis } from './guide.ts';
import {
  EMPTY_OVERLAY,
  type KeyInput,
  type PointerInput,
  type Tool,
  type ToolContext,
  type ToolOverlay,
} from './tool.ts';
import { fillWords } from './tool-words.ts';

const LINE_PIXELS = 10;
const END_PIXELS = 9;
const DRAG_PIXELS = 4;

/** What a press has begun. */
type Gesture =
  | {
      readonly kind: 'press';
      readonly at: ScreenPoint;
      readonly line: number | null;
      /** The end of lines that was pressed. */
      readonly end: Vec3 | null;
      readonly double: boolean;
    }
  | { readonly kind: 'box'; readonly from: ScreenPoint; readonly keep: ReadonlySet<number> }
  | {
      readonly kind: 'move';
      readonly before: SketchDocument;
      readonly plane: GuidePlane;
      readonly grabbed: Vec3;
      readonly apply: (by: Vec3) => { readonly sketch: SketchDocument; readonly along: number };
    };

/**
 * Select by click, by Shift and by a box; drag the selection or an end of lines, and what is joined to it follows along
 * legal lengths, unless Alt tears it off; arrow keys move the selection by one.
 */
export class SelectTool implements Tool {
  readonly id = 'select';
  readonly #context: ToolContext;
  readonly #overlay = signal<ToolOverlay>(EMPTY_OVERLAY);
  readonly overlay: ReadonlySignal<ToolOverlay> = this.#overlay;
  readonly hint: ReadonlySignal<string>;
  #gesture: Gesture | null = null;

  constructor(context: ToolContext) {
    this.#context = context;
    this.hint = signal(context.words.hints.select);
  }

  /** The camera takes what begins on nothing, so that a first drag turns the picture. */
  navigation(at: PointerInput): Navigation {
    const line = this.#lineAt(at);
    const onSelection = line !== null && this.#context.store.selection.value.has(line);
    return at.shift || onSelection || this.#endAt(at) ? 'tool' : 'orbit';
  }

  pointerMove(at: PointerInput): void {
    const gesture = this.#gesture;
    if (!gesture) {
      const end = this.#endAt(at);
      this.#show({
        hovered: this.#lineAt(at),
        ...(end ? { cursor: end, preview: handle(end) } : {}),
      });
      return;
    }
    if (gesture.kind === 'press' && farApart(gesture.at, at)) {
      this.#beginDrag(gesture, at);
    } else if (gesture.kind === 'box') {
      this.#show({ box: { from: gesture.from, to: at } });
    } else if (gesture.kind === 'move') {
      this.#dragTo(gesture, at);
    }
  }

  pointerDown(at: PointerInput): void {
    const [line, end] = [this.#lineAt(at), this.#endAt(at)];
    this.#gesture = { kind: 'press', at, line, end, double: at.double ?? false };
  }

  pointerUp(at: PointerInput): void {
    const gesture = this.#gesture;
    this.#gesture = null;
    if (!gesture) {
      return;
    }
    const { store, words } = this.#context;
    if (gesture.kind === 'press' && !farApart(gesture.at, at)) {
      this.#click(gesture.line, at.shift, gesture.double);
    } else if (gesture.kind === 'box') {
      store.select([...gesture.keep, ...this.#linesInBox(gesture.from, at)]);
    } else if (gesture.kind === 'move') {
      store.commit(words.edits.move, store.sketch.value);
    }
    this.#show({});
  }

  pointerLeave(): void {
    this.reset();
  }

  key(input: KeyInput): boolean {
    const { store, words } = this.#context;
    const selection = store.selection.value;
    const step = selection.size > 0 ? this.#stepFor(input.key) : null;
    if (!step) {
      return false;
    }
    const by = scale(step, input.shift ? 5 : 1);
    store.commit(words.edits.move, mapLines(store.sketch.value, selection, shift(by)));
    return true;
  }

  escape(): boolean {
    if (this.#gesture) {
      this.#gesture = null;
      this.#context.store.rollBack();
      this.#show({});
      return true;
    }
    if (this.#context.store.selection.value.size > 0) {
      this.#context.store.select([]);
      return true;
    }
    return false;
  }

  reset(): void {
    if (this.#gesture) {
      this.#context.store.rollBack();
    }
    this.#gesture = null;
    this.#show({});
  }

  #click(line: number | null, extend: boolean, double: boolean): void {
    const { store } = this.#context;
    if (line === null) {
      if (!extend) {
        store.select([]);
      }
      return;
    }
    if (double) {
      store.select(chainedLines(store.sketch.value, new Set([line])));
      return;
    }
    if (!extend) {
      store.select([line]);
      return;
    }
    const next = new Set(store.selection.value);
    if (!next.delete(line)) {
      next.add(line);
    }
    store.select(next);
  }

  #beginDrag(gesture: Extract<Gesture, { kind: 'press' }>, at: PointerInput): void {
    const { store, view, plane } = this.#context;
    const selection = store.selection.value;
    const picked = gesture.line !== null && selection.has(gesture.line);
    const grabbed = picked ? view.pickAt(gesture.at).line?.point : (gesture.end ?? undefined);
    if (grabbed) {
      const axis = planeAxis(plane.value, view.viewDirection());
      const before = store.sketch.value;
      const apply = this.#pull(before, gesture, { picked, alone: at.alt === true });
      const through = { axis, through: grabbed };
      this.#gesture = { kind: 'move', before, plane: through, grabbed, apply };
      this.pointerMove(at);
      return;
    }
    if (at.shift) {
      this.#gesture = { kind: 'box', from: gesture.at, keep: selection };
      this.pointerMove(at);
    }
  }

  #dragTo(gesture: Extract<Gesture, { kind: 'move' }>, at: PointerInput): void {
    const { store, view, words } = this.#context;
    const hit = meetGuide(view.rayAt(at), gesture.plane);
    if (!hit) {
      return;
    }
    const d = subtract(hit, gesture.grabbed);
    const by: Vec3 = [Math.round(d[0]), Math.round(d[1]), Math.round(d[2])];
    const { sketch, along } = gesture.apply(by);
    store.commit(words.edits.move, sketch, 'later');
    const to = add(gesture.grabbed, by);
    const note = along > 0 ? fillWords(words.draw.follow, { n: along }) : '';
    this.#show({
      plane: { axis: gesture.plane.axis, through: to },
      label: { at: to, main: vectorText(by), note, kind: 'axis' },
    });
  }

  /** What a drag by a vector makes of the drawing, and how many lines besides the dragged ones it takes along. */
  #pull(
    before: SketchDocument,
    { end, line }: Extract<Gesture, { kind: 'press' }>,
    { picked, alone }: { readonly picked: boolean; readonly alone: boolean },
  ): Extract<Gesture, { kind: 'move' }>['apply'] {
    const selection = this.#context.store.selection.value;
    if (alone) {
      return (by) => ({
        sketch:
          picked || end === null || line === null
            ? mapLines(before, selection, shift(by))
            : tearOff(before, line, end, by),
        along: 0,
      });
    }
    const grabbed = picked ? selection : new Set<number>();
    const points = picked
      ? before.lines.flatMap(({ from, to }, i) => (selection.has(i) ? [from, to] : []))
      : end
        ? [end]
        : [];
    return (by) => {
      if (by.every((x) => x === 0)) {
        return { sketch: before, along: 0 };
      }
      const { sketch, changed, carried } = stretch(before, points, by);
      const along = [...changed, ...carried].filter((i) => !grabbed.has(i)).length;
      return { sketch, along };
    };
  }

  /** An end of lines under the pointer. */
  #endAt(at: PointerInput): Vec3 | null {
    const { store, view } = this.#context;
    const node = view.pickAt(at).node;
    const ends = (index: number) => {
      const line = store.sketch.value.lines[index];
      return line ? [pointKey(line.from), pointKey(line.to)] : [];
    };
    const isEnd = node?.lines.some((index) => ends(index).includes(pointKey(node.at)));
    return node && isEnd && node.distance <= END_PIXELS ? node.at : null;
  }

  #linesInBox(a: ScreenPoint, b: ScreenPoint): number[] {
    const { store, view } = this.#context;
    const inside = (point: Vec3) => {
      const p = view.project(point);
      const acrossIn = p.x >= Math.min(a.x, b.x) && p.x <= Math.max(a.x, b.x);
      return p.visible && acrossIn && p.y >= Math.min(a.y, b.y) && p.y <= Math.max(a.y, b.y);
    };
    return store.sketch.value.lines.flatMap((line, i) =>
      inside(line.from) && inside(line.to) ? [i] : [],
    );
  }

  #lineAt(at: ScreenPoint): number | null {
    const line = this.#context.view.pickAt(at).line;
    return line && line.distance <= LINE_PIXELS ? line.index : null;
  }

  #stepFor(key: string): Vec3 | null {
    const { plane, view } = this.#context;
    const axis = planeAxis(plane.value, view.viewDirection());
    const [first, second] = planeAxes(axis);
    switch (key) {
      case 'ArrowRight':
        return unitVector(first);
      case 'ArrowLeft':
        return scale(unitVector(first), -1);
      case 'ArrowUp':
        return unitVector(second);
      case 'ArrowDown':
        return scale(unitVector(second), -1);
      case 'PageUp':
        return unitVector(axis);
      case 'PageDown':
        return scale(unitVector(axis), -1);
      default:
        return null;
    }
  }

  #show(part: Partial<ToolOverlay>): void {
    this.#overlay.value = { ...EMPTY_OVERLAY, ...part };
  }
}

/** A mark on the end that would be pulled. */
function handle(at: Vec3): ToolOverlay['preview'] {
  return { from: at, to: null, state: 'ok', snap: 'node' };
}

/** Such as `X +2, Z −1`. */
function vectorText(by: Vec3): string {
  const parts = AXIS_NAMES.flatMap((name, k) => {
    const x = by[k] ?? 0;
    return x === 0 ? [] : [`${name.toUpperCase()} ${x > 0 ? '+' : '\u2212'}${Math.abs(x)}`];
  });
  return parts.length > 0 ? parts.join(', ') : '0';
}

function farApart(a: ScreenPoint, b: ScreenPoint): boolean {
  return Math.hypot(a.x - b.x, a.y - b.y) > DRAG_PIXELS;
}
