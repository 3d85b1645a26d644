import type { PointerInput } from '../tools/tool.ts';

/** Who is told what the pointer does in the drawing. */
export interface PointerTarget {
  pressed(at: PointerInput): void;
  moved(at: PointerInput): void;
  released(at: PointerInput): void;
  left(): void;
  abandoned(): void;
  /** @returns whether a key over the drawing was meant for something that lies over it. */
  typed(key: string): boolean;
}

/**
 * Turns the browser's pointer events into presses, moves and releases of one pointer. It listens
 * before the camera's controls do, so that who gets a press is decided before they see it. A second
 * finger, or another button, belongs to the camera.
 */
export class PointerFeed {
  readonly #canvas: HTMLCanvasElement;
  readonly #target: PointerTarget;
  readonly #stop = new AbortController();
  readonly #down = new Set<number>();
  #primary: number | null = null;
  #lastPress: PointerEvent | null = null;

  constructor(host: HTMLElement, canvas: HTMLCanvasElement, target: PointerTarget) {
    this.#canvas = canvas;
    this.#target = target;
    const options = { capture: true, signal: this.#stop.signal };
    host.addEventListener('pointerdown', (event) => this.#onDown(event), options);
    host.addEventListener('pointermove', (event) => this.#onMove(event), options);
    // On the window: a release outside of the drawing is a release all the same.
    window.addEventListener('pointerup', (event) => this.#onUp(event), options);
    window.addEventListener('pointercancel', (event) => this.#onCancel(event), options);
    host.addEventListener('pointerleave', (event) => this.#onLeave(event), {
      signal: this.#stop.signal,
    });
    canvas.addEventListener(
      'keydown',
      (event) => {
        const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
        if (plain && this.#target.typed(event.key)) {
          event.preventDefault();
          event.stopPropagation();
        }
      },
      { signal: this.#stop.signal },
    );
    host.addEventListener('contextmenu', (event) => event.preventDefault(), options);
  }

  dispose(): void {
    this.#stop.abort();
  }

  #onDown(event: PointerEvent): void {
    // What lies over the drawing, as the field of a length, has its presses for itself.
    if (event.target !== this.#canvas) {
      return;
    }
    this.#down.add(event.pointerId);
    this.#canvas.focus({ preventScroll: true });
    if (this.#down.size > 1) {
      this.#primary = null;
      this.#target.abandoned();
      return;
    }
    if (event.button === 0) {
      this.#primary = event.pointerId;
      const double = this.#isDouble(event);
      this.#lastPress = double ? null : event;
      this.#target.pressed({ ...this.#input(event), double });
    }
  }

  /** Pointer events do not count clicks: two presses in one place within a moment are a double one. */
  #isDouble(event: PointerEvent): boolean {
    const last = this.#lastPress;
    const near = last && Math.hypot(event.clientX - last.clientX, event.clientY - last.clientY);
    return last !== null && near !== null && near < 8 && event.timeStamp - last.timeStamp < 400;
  }

  #onMove(event: PointerEvent): void {
    const hovering = this.#down.size === 0;
    if (hovering || event.pointerId === this.#primary) {
      this.#target.moved(this.#input(event));
    }
  }

  #onUp(event: PointerEvent): void {
    this.#down.delete(event.pointerId);
    if (event.pointerId === this.#primary) {
      this.#primary = null;
      this.#target.released(this.#input(event));
    }
  }

  #onCancel(event: PointerEvent): void {
    this.#down.delete(event.pointerId);
    if (event.pointerId === this.#primary) {
      this.#primary = null;
      this.#target.abandoned();
    }
  }

  #onLeave(event: PointerEvent): void {
    if (this.#down.size === 0 && event.pointerType !== 'touch') {
      this.#target.left();
    }
  }

  #input(event: PointerEvent): PointerInput {
    const box = this.#canvas.getBoundingClientRect();
    const { pointerType } = event;
    return {
      x: event.clientX - box.left,
      y: event.clientY - box.top,
      shift: event.shiftKey,
      alt: event.altKey,
      kind: pointerType === 'touch' || pointerType === 'pen' ? pointerType : 'mouse',
    };
  }
}
