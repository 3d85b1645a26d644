import { type ReadonlySignal, type Signal, signal } from '@preact/signals';
import { angleOf, draggedEnd } from '../geometry/joint-frame.ts';
import { AXIS_NAMES, add, dot, scale, subtract, unitVector } from '../geometry/vec.ts';
import type { SketchJoint } from '../model/sketch.ts';
import {
  dropJoint,
  insertJoint,
  type JointPlace,
  jointIndex,
  jointsAt,
  legalRange,
  likelyJoint,
  linesAt,
  moveLine,
  placeOfJoint,
  replaceJoint,
  withRange,
} from '../state/joint-edits.ts';
import { frameOf, handlePlaces, type JointHandle, ringRadius } from '../view/joint-ring.ts';
import type { Navigation } from '../view/view-types.ts';
import { NodeTool, type ToolNode } from './node-tools.ts';
import type { KeyInput, PointerInput, ToolContext, ToolOverlay } from './tool.ts';
import { fillWords } from './tool-words.ts';

const HANDLE_PIXELS = { mouse: 13, pen: 16, touch: 26 } as const;
const CLICK_PIXELS = 6;
/** Degrees that a dragged end of a range goes by; with Shift by single ones. */
const STEP = 5;
/** A range that comes so near to the half turn is one. */
const NEARLY_FULL = 172;

interface Drag {
  readonly handle: JointHandle;
  readonly frame: ReturnType<typeof frameOf>;
}

/** Sets joints at junctions; the one that is chosen can be turned, told what moves and how far. */
export class JointTool extends NodeTool {
  readonly id = 'joint';
  readonly hint: ReadonlySignal<string>;
  readonly #chosen: Signal<JointPlace | null>;
  #drag: Drag | null = null;
  #dragged = false;
  #lineDown: PointerInput | null = null;

  constructor(context: ToolContext) {
    super(context);
    this.#chosen = context.joint;
    this.hint = signal(context.words.hints.joint);
  }

  protected suits({ at, lines }: ToolNode): boolean {
    const { sketch } = this.context.store;
    return lines.length > 1 || jointsAt(sketch.value, at).length > 0;
  }

  /** A joint where none was; else the next of those that are there. */
  protected apply({ at }: ToolNode): void {
    const { store, words } = this.context;
    const sketch = store.sketch.value;
    const there = jointsAt(sketch, at);
    if (there.length > 0) {
      const now = this.#index();
      const nth = now === null ? -1 : there.indexOf(now);
      this.#chosen.value = { at, nth: (nth + 1) % there.length };
      return;
    }
    const joint = likelyJoint(sketch, at);
    if (!joint) {
      this.context.announce(words.joint.needsTwo);
      return;
    }
    const next = insertJoint(sketch, joint);
    store.commit(words.edits.joint, next);
    this.#chosen.value = placeOfJoint(next, (next.joints?.length ?? 1) - 1);
  }

  override navigation(at: PointerInput): Navigation {
    return this.#handleAt(at) || this.#lineAt(at) !== null ? 'tool' : super.navigation(at);
  }

  override pointerMove(at: PointerInput): void {
    if (this.#drag) {
      this.#pull(this.#drag, at);
      this.#dragged = true;
      return;
    }
    super.pointerMove(at);
    const handle = this.#handleAt(at);
    const hovered = handle ? null : this.#lineAt(at);
    this.showMore({ handle, hovered });
  }

  override pointerDown(at: PointerInput): void {
    const joint = this.#joint();
    const handle = this.#handleAt(at);
    if (joint && handle) {
      this.#drag = { handle, frame: frameOf(this.context.store.sketch.value, joint) };
      this.#dragged = false;
      this.showMore({ handle, label: this.#label(handle) });
      return;
    }
    this.#lineDown = at;
    super.pointerDown(at);
  }

  override pointerUp(at: PointerInput): void {
    if (this.#drag) {
      this.#drag = null;
      const { store, words } = this.context;
      store.commit(words.edits.joint, store.sketch.value);
      this.showMore({ handle: null, label: null });
      const node = this.#dragged ? null : this.nodeAt(at);
      if (node) {
        // Seen along its axis, the ends lie over the joint: a click is meant for that.
        this.apply(node);
      }
      return;
    }
    const from = this.#lineDown;
    this.#lineDown = null;
    const line = this.#lineAt(at);
    const still = from !== null && Math.hypot(at.x - from.x, at.y - from.y) <= CLICK_PIXELS;
    if (still && line !== null) {
      this.#change((joint) => moveLine(this.context.store.sketch.value, joint, line));
      return;
    }
    super.pointerUp(at);
  }

  override pointerLeave(): void {
    this.#dropDrag();
    super.pointerLeave();
  }

  override key(input: KeyInput): boolean {
    const joint = this.#joint();
    const axis = AXIS_NAMES.find((name) => name === input.key.toLowerCase());
    if (!joint) {
      return super.key(input);
    }
    if (axis) {
      this.#change((old) => ({ ...old, axis: unitVector(axis) }));
      return true;
    }
    if (input.key === 'Delete' || input.key === 'Backspace') {
      this.#remove();
      return true;
    }
    const line = linesAt(this.context.store.sketch.value, joint.at)[Number(input.key) - 1];
    if (line !== undefined) {
      this.#change((old) => moveLine(this.context.store.sketch.value, old, line));
      return true;
    }
    return super.key(input);
  }

  override escape(): boolean {
    if (this.#drag) {
      this.#dropDrag();
      return true;
    }
    if (super.escape()) {
      return true;
    }
    const had = this.#joint() !== null;
    this.#chosen.value = null;
    return had;
  }

  override reset(): void {
    this.#dropDrag();
    super.reset();
  }

  #index(): number | null {
    return jointIndex(this.context.store.sketch.value, this.#chosen.value);
  }

  #joint(): SketchJoint | null {
    const index = this.#index();
    return index === null ? null : (this.context.store.sketch.value.joints?.[index] ?? null);
  }

  #change(change: (joint: SketchJoint) => SketchJoint, capture: 'now' | 'later' = 'now'): void {
    const { store, words } = this.context;
    const sketch = store.sketch.value;
    const index = this.#index();
    const joint = index === null ? undefined : sketch.joints?.[index];
    const next = joint && change(joint);
    if (index !== null && joint && next && JSON.stringify(next) !== JSON.stringify(joint)) {
      store.commit(words.edits.joint, replaceJoint(sketch, index, next), capture);
    }
  }

  #remove(): void {
    const { store, words } = this.context;
    const index = this.#index();
    if (index !== null) {
      store.commit(words.edits.joint, dropJoint(store.sketch.value, index));
    }
  }

  #radius(): number {
    return ringRadius(this.context.view.pixelsPerModule());
  }

  #handleAt(at: PointerInput): JointHandle | null {
    const joint = this.#joint();
    if (!joint) {
      return null;
    }
    const frame = frameOf(this.context.store.sketch.value, joint);
    const places = handlePlaces(frame, joint.range, this.#radius());
    let best: JointHandle | null = null;
    let nearest: number = HANDLE_PIXELS[at.kind];
    for (const handle of ['to', 'from', 'axis', 'axisEnd'] as const) {
      const seen = this.context.view.project(places[handle]);
      const distance = Math.hypot(seen.x - at.x, seen.y - at.y);
      if (seen.visible && distance < nearest) {
        nearest = distance;
        best = handle;
      }
    }
    return best;
  }

  /** The line of the chosen joint's node under the pointer, where no junction is. */
  #lineAt(at: PointerInput): number | null {
    const joint = this.#joint();
    const { line } = this.context.view.pickAt(at);
    const node = this.nodeAt(at);
    if (!joint || !line || (node && this.suits(node))) {
      return null;
    }
    return linesAt(this.context.store.sketch.value, joint.at).includes(line.index)
      ? line.index
      : null;
  }

  #pull({ handle, frame }: Drag, at: PointerInput): void {
    if (handle === 'axis' || handle === 'axisEnd') {
      this.#change((joint) => this.#turned(joint, at, handle === 'axis' ? 1 : -1), 'later');
    } else {
      this.#pullRange(handle, frame, at);
    }
    this.showMore({ handle, label: this.#label(handle) });
  }

  /** About the principal axis whose end on screen is nearest to the pointer: no part has holes along others. */
  #turned(joint: SketchJoint, at: PointerInput, end: 1 | -1): SketchJoint {
    const reach = this.#radius() * 1.35;
    const ways = AXIS_NAMES.flatMap((name) => [unitVector(name), scale(unitVector(name), -1)]);
    const distances = ways.map((way) => {
      const seen = this.context.view.project(add(joint.at, scale(way, reach)));
      return Math.hypot(seen.x - at.x, seen.y - at.y);
    });
    const way = ways[distances.indexOf(Math.min(...distances))];
    // Adding nothing makes 0 of -0.
    return way ? { ...joint, axis: add(scale(way, end), [0, 0, 0]) } : joint;
  }

  #pullRange(handle: 'from' | 'to', frame: Drag['frame'], at: PointerInput): void {
    const { origin, direction } = this.context.view.rayAt(at);
    const slope = dot(direction, frame.axis);
    if (Math.abs(slope) < 0.05) {
      // Seen from the side the ring is a stroke, and no place on screen is one angle.
      return;
    }
    const t = dot(subtract(frame.at, origin), frame.axis) / slope;
    const angle = angleOf(frame, add(origin, scale(direction, t)));
    const sign = handle === 'to' ? 1 : -1;
    this.#change((joint) => {
      const [from, to] = joint.range ?? [0, 0];
      const end = draggedEnd(sign, handle === 'to' ? to : from, angle);
      const step = at.shift ? 1 : STEP;
      const whole = Math.abs(end) >= NEARLY_FULL ? sign * 180 : Math.round(end / step) * step;
      const range = handle === 'to' ? legalRange(from, whole) : legalRange(whole, to);
      return withRange(joint, range);
    }, 'later');
  }

  #label(handle: JointHandle): ToolOverlay['label'] {
    const joint = this.#joint();
    const { words } = this.context;
    if (!joint) {
      return null;
    }
    const frame = frameOf(this.context.store.sketch.value, joint);
    const at = handlePlaces(frame, joint.range, this.#radius())[handle];
    if (handle === 'axis' || handle === 'axisEnd') {
      const axis = AXIS_NAMES.find((name) => Math.abs(dot(unitVector(name), frame.axis)) > 0.999);
      const note = words.joint.axis;
      return { at, main: axis?.toUpperCase() ?? '', note, kind: 'axis' };
    }
    const [from, to] = joint.range ?? [0, 0];
    const main = joint.range ? fillWords(words.joint.degrees, { from, to }) : words.joint.noRange;
    return { at, main, note: words.joint.range, kind: 'plane' };
  }

  #dropDrag(): void {
    if (this.#drag) {
      this.#drag = null;
      this.context.store.rollBack();
    }
    this.#lineDown = null;
  }
}
