import { distance, subtract, type Vec3 } from '../geometry/vec.ts';
import type { GuidePlane, ScreenPoint } from '../view/view-types.ts';
import { PointTool } from './point-tool.ts';
import { type Located, locateFree } from './snap.ts';
import { fillWords } from './tool-words.ts';

/** The distance between two points, and its share along each axis. Changes nothing. */
export class MeasureTool extends PointTool {
  readonly id = 'measure';
  #last = '';

  protected describe(): string {
    const { hints } = this.context.words;
    return this.points.length === 0 ? this.#last || hints.measure : hints.measureNext;
  }

  protected locate(at: ScreenPoint, plane: GuidePlane): Located | null {
    return locateFree(this.context.view, at, plane);
  }

  protected place(to: Vec3): void {
    const [from] = this.points;
    if (!from) {
      this.points = [to];
      return;
    }
    this.points = [];
    this.#last = sentence(this.context.words.draw.measured, from, to);
    this.context.announce(this.#last);
  }

  protected previewTo(to: Vec3): readonly (readonly [Vec3, Vec3])[] {
    const [from] = this.points;
    return from ? [[from, to]] : [];
  }

  protected accepts(): boolean {
    return true;
  }

  protected measure(to: Vec3): string {
    const from = this.points[0] ?? to;
    const parts = subtract(to, from).map((value) => String(rounded(Math.abs(value))));
    return `${rounded(distance(from, to))}  (${parts.join(' · ')})`;
  }

  protected override typedIsLength(): boolean {
    return false;
  }
}

function sentence(words: string, from: Vec3, to: Vec3): string {
  const [x, y, z] = subtract(to, from).map((value) => rounded(Math.abs(value)));
  const modules = distance(from, to);
  return fillWords(words, {
    n: rounded(modules),
    mm: Math.round(modules * 80) / 10,
    x: x ?? 0,
    y: y ?? 0,
    z: z ?? 0,
  });
}

function rounded(value: number): number {
  return Math.round(value * 100) / 100;
}
