import { distance, samePoint, type Vec3 } from '../geometry/vec.ts';
import { addShaft, isLegalShaft } from '../state/shaft-edits.ts';
import type { GuidePlane, ScreenPoint } from '../view/view-types.ts';
import { PointTool } from './point-tool.ts';
import { type Located, locateEnd, locateFree } from './snap.ts';
import { fillWords } from './tool-words.ts';

/** A shaft from end to end; where it crosses lines it turns in their holes. */
export class ShaftTool extends PointTool {
  readonly id = 'shaft';

  protected describe(): string {
    const { hints } = this.context.words;
    return this.points.length === 0 ? hints.shaft : hints.shaftNext;
  }

  protected locate(at: ScreenPoint, plane: GuidePlane): Located | null {
    const { view, store } = this.context;
    const from = this.points.at(-1);
    return from
      ? locateEnd(view, at, plane, { from, lock: this.lock, lines: store.sketch.value.lines })
      : locateFree(view, at, plane);
  }

  protected place(to: Vec3): void {
    const from = this.points.at(-1);
    if (!from || samePoint(from, to)) {
      this.points = from ? [] : [to];
      return;
    }
    const { store, words, announce } = this.context;
    const after = addShaft(store.sketch.value, { from, to });
    store.commit(words.edits.shaft, after);
    const count = after.shafts?.length ?? 0;
    announce(fillWords(words.draw.shaftDrawn, { n: Math.round(distance(from, to)), count }));
    this.points = [];
  }

  protected previewTo(to: Vec3): readonly (readonly [Vec3, Vec3])[] {
    const from = this.points.at(-1);
    return from ? [[from, to]] : [];
  }

  protected accepts(to: Vec3): boolean {
    const from = this.points.at(-1);
    return from ? samePoint(from, to) || isLegalShaft(from, to) : to.every(Number.isInteger);
  }

  protected measure(to: Vec3): string {
    const from = this.points.at(-1) ?? to;
    return String(Math.round(distance(from, to) * 100) / 100);
  }
}
