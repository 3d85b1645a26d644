import { isLegalLine } from '../geometry/legal-line.ts';
import { distance, samePoint, type Vec3 } from '../geometry/vec.ts';
import { beamFor } from '../model/beam-for.ts';
import { addLines } from '../state/edits.ts';
import type { GuidePlane, ScreenPoint } from '../view/view-types.ts';
import { PointTool } from './point-tool.ts';
import { type Located, locateEnd, locateFree } from './snap.ts';
import { fillWords } from './tool-words.ts';

/** Lines from point to point: the end of one is the beginning of the next. */
export class LineTool extends PointTool {
  readonly id = 'line';
  /** First point of the chain: reaching it closes the figure and ends the chain. */
  #first: Vec3 | null = null;

  protected describe(): string {
    const { hints } = this.context.words;
    return this.points.length === 0 ? hints.line : hints.lineNext;
  }

  protected locate(at: ScreenPoint, plane: GuidePlane): Located | null {
    const { view } = this.context;
    const from = this.points.at(-1);
    return from
      ? locateEnd(view, at, plane, {
          from,
          lock: this.lock,
          lines: this.context.store.sketch.value.lines,
        })
      : locateFree(view, at, plane);
  }

  protected place(to: Vec3): void {
    const from = this.points.at(-1);
    if (!from) {
      this.points = [to];
      this.#first = to;
      return;
    }
    if (samePoint(from, to)) {
      this.points = [];
      return;
    }
    const { store, words, announce } = this.context;
    const before = store.sketch.value;
    const after = addLines(before, [{ from, to }]);
    store.commit(words.edits.draw, after);
    announce(
      fillWords(words.draw.lineDrawn, {
        n: Math.round(distance(from, to)),
        count: after.lines.length,
      }),
    );
    const closed = this.#first !== null && samePoint(this.#first, to);
    this.points = closed ? [] : [to];
  }

  protected previewTo(to: Vec3): readonly (readonly [Vec3, Vec3])[] {
    const from = this.points.at(-1);
    return from ? [[from, to]] : [];
  }

  protected accepts(to: Vec3): boolean {
    const from = this.points.at(-1);
    // The last point again ends the chain.
    return !from || samePoint(from, to) || isLegalLine(from, to);
  }

  protected measure(to: Vec3): string {
    const from = this.points.at(-1) ?? to;
    const length = Math.round(distance(from, to) * 100) / 100;
    if (!Number.isInteger(length) || length < 1) {
      return String(length);
    }
    const { kind, holes } = beamFor(length);
    return fillWords(this.context.words.draw.becomes[kind], { n: length, holes });
  }
}
