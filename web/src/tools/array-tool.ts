import { samePoint, scale, subtract, type Vec3 } from '../geometry/vec.ts';
import { copyLines } from '../state/copy-lines.ts';
import { mapLine, shift } from '../state/edits.ts';
import { MAX_COPIES } from '../state/offset-lines.ts';
import type { GuidePlane, ScreenPoint } from '../view/view-types.ts';
import { PointTool } from './point-tool.ts';
import { type Located, locateFree } from './snap.ts';
import { fillWords } from './tool-words.ts';

const DEFAULT_COPIES = 2;

/** Copies of the selection in a row: from where, to where the first copy lies, and how many. */
export class ArrayTool extends PointTool {
  readonly id = 'array';
  #copies = DEFAULT_COPIES;

  protected describe(): string {
    const { hints } = this.context.words;
    if (this.context.store.selection.value.size === 0) {
      return hints.arrayNone;
    }
    const words = this.points.length === 0 ? hints.array : hints.arrayNext;
    return fillWords(words, { n: this.#count() });
  }

  protected locate(at: ScreenPoint, plane: GuidePlane): Located | null {
    return locateFree(this.context.view, at, plane);
  }

  protected place(to: Vec3): void {
    const [from] = this.points;
    const { store, words } = this.context;
    if (store.selection.value.size === 0) {
      return;
    }
    if (!from) {
      this.points = [to];
      return;
    }
    this.#copies = this.#count();
    this.points = [];
    const { sketch } = copyLines(
      store.sketch.value,
      store.selection.value,
      this.#steps(from, to).map(shift),
    );
    store.commit(words.edits.array, sketch);
  }

  protected previewTo(to: Vec3): readonly (readonly [Vec3, Vec3])[] {
    const [from] = this.points;
    const { store } = this.context;
    const chosen = store.sketch.value.lines.filter((_, i) => store.selection.value.has(i));
    return from
      ? [
          [from, to],
          ...this.#steps(from, to).flatMap((step) =>
            chosen.map((line): readonly [Vec3, Vec3] => {
              const copy = mapLine(line, shift(step));
              return [copy.from, copy.to];
            }),
          ),
        ]
      : [];
  }

  protected accepts(to: Vec3): boolean {
    const [from] = this.points;
    return !from || !samePoint(from, to);
  }

  protected measure(): string {
    return `× ${this.#count()}`;
  }

  protected override typedIsLength(): boolean {
    return false;
  }

  #steps(from: Vec3, to: Vec3): Vec3[] {
    const step = subtract(to, from);
    return Array.from({ length: this.#count() }, (_, i) => scale(step, i + 1));
  }

  #count(): number {
    return Math.min(MAX_COPIES, this.typedNumber() ?? this.#copies);
  }
}
