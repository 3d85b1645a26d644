import { type ReadonlySignal, type Signal, signal } from '@preact/signals';
import { axisOf } from '../geometry/legal-line.ts';
import {
  type AxisName,
  add,
  distance,
  samePoint,
  scale,
  unitVector,
  type Vec3,
} from '../geometry/vec.ts';
import type { GuidePlane, Navigation, ScreenPoint, SnapKind } from '../view/view-types.ts';
import { planeAxes, planeAxis } from './guide.ts';
import { endAtLength, type Located } from './snap.ts';
import {
  EMPTY_OVERLAY,
  type KeyInput,
  type PointerInput,
  type Tool,
  type ToolContext,
  type ToolId,
  type ToolOverlay,
} from './tool.ts';
import { fillWords } from './tool-words.ts';
import { sizesOf, tidySizes } from './typed-sizes.ts';

/** A press that moves farther than this is a drag, in pixels. */
const DRAG_PIXELS = 8;
/** What is typed between two sizes, as in `6,8,4`. */
const SEPARATORS = [',', ';', '*', '×'];

/** What the drawing tools have in common: points placed one after the other by pointer or by keys. */
export abstract class PointTool implements Tool {
  abstract readonly id: ToolId;
  protected readonly context: ToolContext;
  protected points: readonly Vec3[] = [];
  /** Where the next point would be. Null until the pointer or a key has said so. */
  protected located: Located | null = null;
  protected lock: AxisName | null = null;
  protected typed = '';
  readonly #overlay = signal<ToolOverlay>(EMPTY_OVERLAY);
  readonly #hint: Signal<string> = signal('');
  #pressedAt: ScreenPoint | null = null;
  #startedByPress = false;

  readonly overlay: ReadonlySignal<ToolOverlay> = this.#overlay;
  readonly hint: ReadonlySignal<string> = this.#hint;

  constructor(context: ToolContext) {
    this.context = context;
  }

  /** The sentence for the present step. */
  protected abstract describe(): string;
  /** Where a point at the pointer would be placed. */
  protected abstract locate(at: ScreenPoint, plane: GuidePlane): Located | null;
  /** Takes the point; sets `points` for the next step. */
  protected abstract place(point: Vec3): void;
  /** Lines that would be drawn if the next point were `to`. */
  protected abstract previewTo(to: Vec3): readonly (readonly [Vec3, Vec3])[];
  /** Whether the next point may be `to`. */
  protected abstract accepts(to: Vec3): boolean;
  /** Main text of the label: lengths. */
  protected abstract measure(to: Vec3): string;

  navigation(): Navigation {
    return 'tool';
  }

  pointerMove(at: PointerInput): void {
    const located = this.locate(at, this.plane());
    if (located) {
      this.located = located;
      this.#applyTyped();
    }
    this.refresh();
  }

  pointerDown(at: PointerInput): void {
    this.#pressedAt = at;
    this.pointerMove(at);
    this.#startedByPress = this.points.length === 0;
    if (this.#startedByPress) {
      this.commit();
    }
  }

  pointerUp(at: PointerInput): void {
    const pressed = this.#pressedAt;
    this.#pressedAt = null;
    if (!pressed) {
      return;
    }
    const dragged = Math.hypot(at.x - pressed.x, at.y - pressed.y) > DRAG_PIXELS;
    if (this.#startedByPress && !dragged) {
      return;
    }
    this.pointerMove(at);
    this.commit();
  }

  pointerLeave(): void {
    // A second finger turns the view: the point that the first one has just begun is not meant.
    if (this.#pressedAt && this.#startedByPress) {
      this.points = [];
    }
    this.#pressedAt = null;
    if (this.points.length === 0) {
      this.located = null;
    }
    this.refresh();
  }

  key(input: KeyInput): boolean {
    const lower = input.key.toLowerCase();
    const parts = SEPARATORS.includes(input.key) && this.typed !== '' && this.sizes() > 1;
    if (/^\d$/.test(input.key) || parts) {
      this.type(this.typed + (parts ? ',' : input.key));
      return true;
    }
    if (lower === 'x' || lower === 'y' || lower === 'z') {
      return this.#toggleLock(lower);
    }
    switch (input.key) {
      case 'Backspace':
        return this.#untype();
      case 'Enter':
        this.located ??= this.keyboardStart();
        this.commit();
        return true;
      case 'Tab':
        // With nothing begun, Tab must leave the drawing for the rest of the page.
        if (input.shift || this.points.length === 0) {
          return false;
        }
        this.context.nextPlane();
        this.refresh();
        return true;
      default:
        return this.#moveCursor(input.key);
    }
  }

  escape(): boolean {
    if (this.typed !== '' || this.lock !== null) {
      this.typed = '';
      this.lock = null;
    } else if (this.points.length > 0) {
      this.points = this.points.slice(0, -1);
    } else {
      return false;
    }
    this.refresh();
    return true;
  }

  reset(): void {
    this.points = [];
    this.located = null;
    this.lock = null;
    this.typed = '';
    this.refresh();
  }

  /** The plane drawn on now: through the last point, or through the cursor of the keyboard. */
  protected plane(): GuidePlane {
    const axis = planeAxis(this.context.plane.value, this.context.view.viewDirection());
    return { axis, through: this.points.at(-1) ?? this.restingPoint() };
  }

  /** Where the plane lies before the first point: level with the ground, or through the last end. */
  protected restingPoint(): Vec3 {
    const { lines, ground } = this.context.store.sketch.value;
    return lines.at(-1)?.to ?? [0, 0, ground ?? 0];
  }

  /** How many sizes can be typed for the next step. */
  protected sizes(): number {
    return 1;
  }

  /** Sizes typed so far. */
  protected typedSizes(): readonly number[] {
    return sizesOf(this.typed);
  }

  /** Number typed so far, or null. */
  protected typedNumber(): number | null {
    return this.typedSizes()[0] ?? null;
  }

  type(value: string): void {
    this.typed = tidySizes(value, this.sizes());
    this.beginTyped();
    this.#applyTyped();
    this.refresh();
  }

  /** Before what was typed is applied: the place to begin a figure that is told by its sizes alone. */
  protected beginTyped(): void {
    // Most tools wait for a point.
  }

  /** Begins where the pointer is, or the keyboard's cursor, unless something is begun. */
  protected beginHere(): void {
    if (this.points.length === 0 && this.typed !== '') {
      this.located ??= this.keyboardStart();
      this.points = [this.located.point];
    }
  }

  /** Where the next point would be by what was typed, in place of the pointer's place. */
  protected placeTyped(from: Vec3, to: Vec3): Vec3 {
    const length = this.typedNumber();
    return length === null || !this.typedIsLength() ? to : endAtLength(from, to, length);
  }

  /** Places the point under the cursor, or says why not. */
  protected commit(): void {
    const to = this.located?.point;
    if (!to) {
      return;
    }
    if (this.points.length > 0 && !this.accepts(to)) {
      this.context.announce(this.context.words.draw.noWholeLength);
      return;
    }
    this.place(to);
    this.typed = '';
    this.lock = null;
    this.refresh();
  }

  /** Shows the present state. */
  protected refresh(): void {
    const from = this.points.at(-1) ?? null;
    const to = this.located?.point ?? null;
    const ok = to === null || from === null || this.accepts(to);
    const moved = from !== null && to !== null && !samePoint(from, to);
    const [main, ...more] = moved && to ? this.previewTo(to) : [];
    this.#overlay.value = {
      ...EMPTY_OVERLAY,
      plane: this.plane(),
      cursor: to,
      preview:
        main && this.located
          ? {
              from: main[0],
              to: main[1],
              state: ok ? 'ok' : 'invalid',
              snap: this.located.snap,
              more,
              ghosts: this.typed === '' ? (this.located.others ?? []) : [],
            }
          : null,
      label: to && moved ? this.#label(to, ok) : null,
      typed: this.typed,
      sizes: this.sizes(),
      lock: this.lock,
    };
    this.#hint.value = this.describe();
  }

  #label(to: Vec3, ok: boolean) {
    const kind: SnapKind | 'invalid' = ok ? (this.located?.snap ?? 'grid') : 'invalid';
    const { words } = this.context;
    const note = ok && this.located ? this.#reason(this.located) : words.draw.noWholeLength;
    return { at: to, main: this.measure(to), note, kind };
  }

  #reason(located: Located): string {
    const axis = located.axis?.toUpperCase() ?? '';
    return fillWords(this.context.words.snap[located.snap], { axis });
  }

  #untype(): boolean {
    if (this.typed === '') {
      return false;
    }
    this.type(this.typed.slice(0, -1));
    return true;
  }

  #applyTyped(): void {
    const from = this.points.at(-1);
    if (from && this.located && this.typed !== '') {
      this.located = { ...this.located, point: this.placeTyped(from, this.located.point) };
    }
  }

  /** Whether a typed number is the distance to the next point. */
  protected typedIsLength(): boolean {
    return true;
  }

  #toggleLock(axis: AxisName): boolean {
    const from = this.points.at(-1);
    if (!from) {
      return false;
    }
    this.lock = this.lock === axis ? null : axis;
    const reach = this.located ? Math.max(1, Math.round(distance(from, this.located.point))) : 1;
    if (this.lock && axisOf(from, this.located?.point ?? from) !== axis) {
      this.located = { point: add(from, scale(unitVector(axis), reach)), snap: 'axis', axis };
    }
    this.refresh();
    return true;
  }

  #moveCursor(key: string): boolean {
    const plane = this.plane();
    const step = this.#stepFor(key, plane);
    if (!step) {
      return false;
    }
    const at = this.located ?? this.keyboardStart();
    const point = add(at.point, step);
    const from = this.points.at(-1);
    const axis = from ? axisOf(from, point) : null;
    this.located = { point, snap: axis ? 'axis' : 'grid', axis };
    this.typed = '';
    this.refresh();
    this.context.announce(describePoint(this.context.words.draw.cursorAt, point));
    return true;
  }

  protected keyboardStart(): Located {
    return { point: this.points.at(-1) ?? this.restingPoint(), snap: 'grid', axis: null };
  }

  /** Arrow keys follow the screen: the axis of the plane that points most to the right is "right". */
  #stepFor(key: string, plane: GuidePlane): Vec3 | null {
    if (key === 'PageUp' || key === 'PageDown') {
      return scale(unitVector(plane.axis), key === 'PageUp' ? 1 : -1);
    }
    const [first, second] = planeAxes(plane.axis).map((axis) => this.#onScreen(axis));
    if (!first || !second) {
      return null;
    }
    const firstIsAcross = Math.abs(first.x) >= Math.abs(second.x);
    const across = firstIsAcross ? first : second;
    const along = firstIsAcross ? second : first;
    const right = scale(across.unit, across.x >= 0 ? 1 : -1);
    const up = scale(along.unit, along.y <= 0 ? 1 : -1);
    switch (key) {
      case 'ArrowRight':
        return right;
      case 'ArrowLeft':
        return scale(right, -1);
      case 'ArrowUp':
        return up;
      case 'ArrowDown':
        return scale(up, -1);
      default:
        return null;
    }
  }

  #onScreen(axis: AxisName): { unit: Vec3; x: number; y: number } {
    const unit = unitVector(axis);
    const base = this.located?.point ?? this.restingPoint();
    const a = this.context.view.project(base);
    const b = this.context.view.project(add(base, unit));
    return { unit, x: b.x - a.x, y: b.y - a.y };
  }
}

/** A sentence about a point, coordinates to two decimals. */
export function describePoint(sentence: string, point: Vec3): string {
  const [x, y, z] = point.map((value) => Math.round(value * 100) / 100);
  return fillWords(sentence, { x: x ?? 0, y: y ?? 0, z: z ?? 0 });
}
