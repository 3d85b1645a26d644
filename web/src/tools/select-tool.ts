import { type ReadonlySignal, signal } from '@preact/signals';
import { add, scale, subtract, unitVector, type Vec3 } from '../geometry/vec.ts';
import type { SketchDocument } from '../model/sketch.ts';
import { chainedLines } from '../state/connectivity.ts';
import { mapLines, shift } from '../state/edits.ts';
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

const LINE_PIXELS = 10;
const DRAG_PIXELS = 4;

/** What a press has begun. */
type Gesture =
  | {
      readonly kind: 'press';
      readonly at: ScreenPoint;
      readonly line: number | null;
      readonly double: boolean;
    }
  | { readonly kind: 'box'; readonly from: ScreenPoint; readonly keep: ReadonlySet<number> }
  | {
      readonly kind: 'move';
      readonly before: SketchDocument;
      readonly plane: GuidePlane;
      readonly grabbed: Vec3;
    };

/** Select by click, by Shift and by a box; drag the selection; arrow keys move it by one. */
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
    return at.shift || onSelection ? 'tool' : 'orbit';
  }

  pointerMove(at: PointerInput): void {
    const gesture = this.#gesture;
    if (!gesture) {
      this.#show({ hovered: this.#lineAt(at) });
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
    this.#gesture = { kind: 'press', at, line: this.#lineAt(at), double: at.double ?? false };
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
    const grabbed = picked ? view.pickAt(gesture.at).line?.point : undefined;
    if (grabbed) {
      const axis = planeAxis(plane.value, view.viewDirection());
      this.#gesture = {
        kind: 'move',
        before: store.sketch.value,
        plane: { axis, through: grabbed },
        grabbed,
      };
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
    const moved = mapLines(gesture.before, store.selection.value, shift(by));
    store.commit(words.edits.move, moved, 'later');
    this.#show({ plane: { axis: gesture.plane.axis, through: add(gesture.grabbed, by) } });
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

function farApart(a: ScreenPoint, b: ScreenPoint): boolean {
  return Math.hypot(a.x - b.x, a.y - b.y) > DRAG_PIXELS;
}
