import { type ReadonlySignal, signal } from '@preact/signals';
import type { Vec3 } from '../geometry/vec.ts';
import { sketchNodes } from '../model/sketch.ts';
import { splitAt } from '../state/edits.ts';
import type { Navigation, NodePick } from '../view/view-types.ts';
import { describePoint } from './point-tool.ts';
import {
  EMPTY_OVERLAY,
  type KeyInput,
  type PointerInput,
  type Tool,
  type ToolContext,
  type ToolId,
  type ToolOverlay,
} from './tool.ts';

const NODE_PIXELS = 14;
const DRAG_PIXELS = 6;

/** What these tools need to know of a node. */
export type ToolNode = Pick<NodePick, 'at' | 'lines'>;

/** Which way an arrow key goes through the nodes. */
const STEPS: Readonly<Record<string, number>> = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
};

/** A tool that does one thing to the node that is clicked. */
export abstract class NodeTool implements Tool {
  abstract readonly id: ToolId;
  abstract readonly hint: ReadonlySignal<string>;
  protected readonly context: ToolContext;
  readonly #overlay = signal<ToolOverlay>(EMPTY_OVERLAY);
  readonly overlay: ReadonlySignal<ToolOverlay> = this.#overlay;
  #pressedAt: PointerInput | null = null;

  constructor(context: ToolContext) {
    this.context = context;
  }

  protected abstract apply(node: ToolNode): void;
  /** Whether there is something to do at a node. */
  protected abstract suits(node: ToolNode): boolean;
  /** The node that the keys have come to, of those that suit. */
  #chosen: number | null = null;

  navigation(at: PointerInput): Navigation {
    return this.nodeAt(at) ? 'tool' : 'orbit';
  }

  pointerMove(at: PointerInput): void {
    this.#chosen = null;
    this.#show(this.nodeAt(at)?.at ?? null);
  }

  pointerDown(at: PointerInput): void {
    this.#pressedAt = at;
  }

  pointerUp(at: PointerInput): void {
    const pressed = this.#pressedAt;
    this.#pressedAt = null;
    const node = this.nodeAt(at);
    if (node && pressed && Math.hypot(at.x - pressed.x, at.y - pressed.y) <= DRAG_PIXELS) {
      this.apply(node);
    }
  }

  pointerLeave(): void {
    this.#overlay.value = EMPTY_OVERLAY;
  }

  /** Arrow keys go from node to node, Enter does what a click does. */
  key({ key }: KeyInput): boolean {
    const step = STEPS[key];
    if (step === undefined && key !== 'Enter') {
      return false;
    }
    const nodes = sketchNodes(this.context.store.sketch.value.lines).filter((node) =>
      this.suits(node),
    );
    if (step !== undefined) {
      const from = this.#chosen ?? (step > 0 ? -1 : 0);
      this.#chosen = nodes.length === 0 ? null : (from + step + nodes.length) % nodes.length;
    }
    const node = this.#chosen === null ? undefined : nodes[this.#chosen];
    this.#show(node?.at ?? null);
    if (node && step === undefined) {
      this.apply(node);
    } else if (node) {
      this.context.announce(describePoint(this.context.words.draw.cursorAt, node.at));
    }
    return true;
  }

  escape(): boolean {
    const had = this.#chosen !== null;
    this.reset();
    return had;
  }

  reset(): void {
    this.#chosen = null;
    this.#show(null);
  }

  #show(at: Vec3 | null): void {
    const preview = at ? ({ from: at, to: null, state: 'ok', snap: 'node' } as const) : null;
    this.#overlay.value = { ...EMPTY_OVERLAY, cursor: at, preview };
  }

  /** Shows more than the node. */
  protected showMore(more: Partial<ToolOverlay>): void {
    this.#overlay.value = { ...this.#overlay.value, ...more };
  }

  protected nodeAt(at: PointerInput): NodePick | null {
    const node = this.context.view.pickAt(at).node;
    return node && node.distance <= NODE_PIXELS ? node : null;
  }
}

/** Cuts every line through the clicked node in two there. */
export class SplitTool extends NodeTool {
  readonly id = 'split';
  readonly hint = signal(this.context.words.hints.split);

  protected suits({ at, lines }: ToolNode): boolean {
    const sketch = this.context.store.sketch.value;
    return lines.some((index) => splitAt(sketch, index, at) !== sketch);
  }

  protected apply(node: ToolNode): void {
    const { store, words } = this.context;
    let sketch = store.sketch.value;
    for (const index of node.lines) {
      sketch = splitAt(sketch, index, node.at);
    }
    store.commit(words.edits.split, sketch);
  }
}
