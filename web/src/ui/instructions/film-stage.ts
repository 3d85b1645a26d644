import { add, type Vec3 } from '../../geometry/vec.ts';
import type { Addition } from '../../instructions/assembly-plan.ts';
import { filmOffsets } from '../../instructions/flight.ts';
import { ISO_OUT } from '../../view/drawing/drawing-camera.ts';
import { drawn } from '../../view/drawing/drawn-part.ts';
import { StillRenderer } from '../../view/still/still-renderer.ts';
import type { Book } from './book.ts';

/** Seconds for one addition at speed 1. */
export const SECONDS_PER_ADDITION = 0.7;
/** Seconds that the finished model stays. */
export const SECONDS_AT_END = 1.5;

/** Draws any moment of the film of a model. */
export class FilmStage {
  readonly sequence: readonly Addition[];
  readonly #book: Book;
  readonly #renderer: StillRenderer;
  readonly #frame: readonly Vec3[];

  /** @throws Error when the browser cannot draw in 3D. */
  constructor(book: Book) {
    this.#book = book;
    this.sequence = book.plan.steps.flatMap((step) => step.adds);
    this.#renderer = new StillRenderer(book.shelf.catalogue);
    this.#frame = book.model.parts.flatMap((part) => book.shelf.corners(drawn(part)));
  }

  get canvas(): HTMLCanvasElement {
    return this.#renderer.canvas;
  }

  /** Seconds of the whole film at speed 1. */
  get duration(): number {
    return this.sequence.length * SECONDS_PER_ADDITION + SECONDS_AT_END;
  }

  /** @param second of the film at speed 1. */
  draw(second: number, width: number, height: number): void {
    const offsets = filmOffsets(this.sequence, second / SECONDS_PER_ADDITION);
    const parts = this.#book.model.parts.flatMap((part, i) => {
      const offset = offsets.get(i);
      return offset ? [{ ...part, position: add(part.position, offset) }] : [];
    });
    this.#renderer.draw({
      parts,
      width,
      height,
      frame: this.#frame,
      direction: ISO_OUT,
      backdrop: 'studio',
      theme: 'light',
    });
  }

  dispose(): void {
    this.#renderer.dispose();
  }
}
