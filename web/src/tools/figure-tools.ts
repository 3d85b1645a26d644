import {
  type AxisName,
  add,
  axisIndex,
  dot,
  scale,
  subtract,
  unitVector,
  type Vec3,
} from '../geometry/vec.ts';
import { addKeepOut, addLines } from '../state/edits.ts';
import type { GuidePlane, ScreenPoint } from '../view/view-types.ts';
import { boxFrame, gridLines, hexagon, rectangle, type Segment, toLines } from './frame-lines.ts';
import { planeAxes } from './guide.ts';
import { PointTool } from './point-tool.ts';
import { type Located, locateAlong, locateCorner, locateFree } from './snap.ts';
import { fillWords } from './tool-words.ts';

const DEFAULT_CELL = 4;

/** A figure of two points on a plane. The plane stays the one of the first point. */
abstract class PlaneFigureTool extends PointTool {
  protected normal: AxisName = 'z';

  protected abstract segments(a: Vec3, b: Vec3): Segment[];

  protected locate(at: ScreenPoint, plane: GuidePlane): Located | null {
    const { view } = this.context;
    const start = this.points[0];
    return start ? locateCorner(view, at, plane, start) : locateFree(view, at, plane);
  }

  protected place(to: Vec3): void {
    const start = this.points[0];
    if (!start) {
      this.points = [to];
      return;
    }
    const { store, words } = this.context;
    store.commit(words.edits.draw, addLines(store.sketch.value, toLines(this.figure(start, to))));
    this.points = [];
  }

  protected previewTo(to: Vec3): readonly Segment[] {
    const start = this.points[0];
    return start ? this.figure(start, to) : [];
  }

  protected accepts(to: Vec3): boolean {
    const start = this.points[0];
    return !start || toLines(this.figure(start, to)).length > 0;
  }

  protected figure(a: Vec3, b: Vec3): Segment[] {
    this.normal = flatAxis(a, b) ?? this.plane().axis;
    return this.segments(a, b);
  }

  protected measure(to: Vec3): string {
    const start = this.points[0] ?? to;
    return planeAxes(this.plane().axis)
      .map((axis) => Math.abs(Math.round(dot(subtract(to, start), unitVector(axis)))))
      .join(' × ');
  }

  protected override typedIsLength(): boolean {
    return false;
  }
}

export class RectangleTool extends PlaneFigureTool {
  readonly id = 'rectangle';

  protected describe(): string {
    const { hints } = this.context.words;
    return this.points.length === 0 ? hints.rectangle : hints.rectangleNext;
  }

  protected segments(a: Vec3, b: Vec3): Segment[] {
    return rectangle(a, b, this.normal);
  }

  protected override sizes(): number {
    return 2;
  }

  protected override beginTyped(): void {
    this.beginHere();
  }

  protected override placeTyped(from: Vec3, to: Vec3): Vec3 {
    return cornerBySizes(from, to, {
      axes: planeAxes(this.plane().axis),
      sizes: this.typedSizes(),
    });
  }
}

export class GridTool extends PlaneFigureTool {
  readonly id = 'grid';
  #cell = DEFAULT_CELL;

  protected describe(): string {
    const { hints } = this.context.words;
    return this.points.length === 0 ? fillWords(hints.grid, { n: this.#width() }) : hints.gridNext;
  }

  protected segments(a: Vec3, b: Vec3): Segment[] {
    return gridLines(a, b, this.normal, this.#width());
  }

  protected override place(to: Vec3): void {
    // What was typed stays the width for the next grid.
    this.#cell = this.#width();
    super.place(to);
  }

  #width(): number {
    return this.typedNumber() ?? this.#cell;
  }
}

export class HexagonTool extends PlaneFigureTool {
  readonly id = 'hexagon';

  protected describe(): string {
    const { hints } = this.context.words;
    return this.points.length === 0 ? hints.hexagon : hints.hexagonNext;
  }

  protected segments(centre: Vec3, to: Vec3): Segment[] {
    const side = this.#side(centre, to);
    return side === 0 ? [] : hexagon(centre, side, this.plane().axis);
  }

  protected override measure(to: Vec3): string {
    return String(this.#side(this.points[0] ?? to, to));
  }

  #side(centre: Vec3, to: Vec3): number {
    return this.typedNumber() ?? Math.round(Math.hypot(...subtract(to, centre)));
  }
}

/** A base of two points and a height: what becomes of the three is the subclass's. */
abstract class BoxBaseTool extends PointTool {
  protected abstract finish(a: Vec3, b: Vec3, height: number): void;
  #axis: AxisName = 'z';

  protected get axis(): AxisName {
    return this.#axis;
  }

  protected locate(at: ScreenPoint, plane: GuidePlane): Located | null {
    const { view } = this.context;
    const [a, b] = this.points;
    if (!a) {
      return locateFree(view, at, plane);
    }
    return b ? locateAlong(view, at, b, this.#axis) : locateCorner(view, at, plane, a);
  }

  protected place(to: Vec3): void {
    const [a, b] = this.points;
    if (a && b) {
      this.finish(a, b, this.#height(b, to));
      this.points = [];
      this.located = null;
      return;
    }
    if (a) {
      this.#axis = this.plane().axis;
      const height = this.#typedHeight();
      if (height !== undefined) {
        this.finish(a, to, height);
        this.points = [];
        this.located = null;
        return;
      }
    }
    this.points = [...this.points, to];
  }

  protected previewTo(to: Vec3): readonly Segment[] {
    const [a, b] = this.points;
    if (a && b) {
      return boxFrame(a, b, this.#axis, this.#height(b, to));
    }
    if (!a) {
      return [];
    }
    const { axis } = this.plane();
    const height = this.#typedHeight();
    return height === undefined ? rectangle(a, to, axis) : boxFrame(a, to, axis, height);
  }

  protected accepts(to: Vec3): boolean {
    const [a, b] = this.points;
    if (a && b) {
      return this.#height(b, to) !== 0;
    }
    return !a || planeAxes(this.plane().axis).every((axis) => span(a, to, axis) !== 0);
  }

  protected measure(to: Vec3): string {
    const [a, b] = this.points;
    if (a && b) {
      return String(Math.abs(this.#height(b, to)));
    }
    const axes = planeAxes(this.plane().axis);
    const sides = axes.map((axis) => Math.abs(span(a ?? to, to, axis)));
    return [...sides, this.#typedHeight() ?? []].flat().join(' × ');
  }

  protected override typedIsLength(): boolean {
    return this.points.length === 2;
  }

  protected override sizes(): number {
    return this.points.length === 2 ? 1 : 3;
  }

  protected override beginTyped(): void {
    this.beginHere();
  }

  protected override placeTyped(from: Vec3, to: Vec3): Vec3 {
    const axes = this.points.length === 2 ? [this.#axis] : planeAxes(this.plane().axis);
    return cornerBySizes(from, to, { axes, sizes: this.typedSizes() });
  }

  /** The height, where it was typed together with the base. */
  #typedHeight(): number | undefined {
    return this.points.length === 1 ? this.typedSizes()[2] : undefined;
  }

  #height(b: Vec3, to: Vec3): number {
    return span(b, to, this.#axis);
  }
}

export class BoxTool extends BoxBaseTool {
  readonly id = 'box';

  protected describe(): string {
    const { hints } = this.context.words;
    return [hints.box, hints.boxNext, hints.boxHeight][this.points.length] ?? hints.box;
  }

  protected finish(a: Vec3, b: Vec3, height: number): void {
    const { store, words } = this.context;
    const lines = toLines(boxFrame(a, b, this.axis, height));
    store.commit(words.edits.draw, addLines(store.sketch.value, lines));
  }
}

export class KeepOutTool extends BoxBaseTool {
  readonly id = 'keepOut';

  protected describe(): string {
    const { hints } = this.context.words;
    const steps = [hints.keepOut, hints.keepOutNext, hints.keepOutHeight];
    return steps[this.points.length] ?? hints.keepOut;
  }

  protected finish(a: Vec3, b: Vec3, height: number): void {
    const { store, words } = this.context;
    const k = axisIndex(this.axis);
    const top = b.map((value, i) => (i === k ? value + height : value));
    const min = (i: number) => Math.min(a[i] ?? 0, top[i] ?? 0);
    const max = (i: number) => Math.max(a[i] ?? 0, top[i] ?? 0);
    store.commit(
      words.edits.keepOut,
      addKeepOut(store.sketch.value, {
        min: [min(0), min(1), min(2)],
        max: [max(0), max(1), max(2)],
      }),
    );
  }
}

/** The only axis along which the points do not differ, or null. */
function flatAxis(a: Vec3, b: Vec3): AxisName | null {
  const flat = (['x', 'y', 'z'] as const).filter((axis) => span(a, b, axis) === 0);
  return flat.length === 1 ? (flat[0] ?? null) : null;
}

/**
 * The corner across from `from` by sizes along the axes, on the pointer's side of it. A size that is not typed
 * is the pointer's; where that is none, the first one.
 */
function cornerBySizes(
  from: Vec3,
  to: Vec3,
  typed: { readonly axes: readonly AxisName[]; readonly sizes: readonly number[] },
): Vec3 {
  return typed.axes.reduce((corner, axis, i) => {
    const drawn = span(from, to, axis);
    const size = typed.sizes[i] ?? (Math.abs(drawn) || (typed.sizes[0] ?? 0));
    return add(corner, scale(unitVector(axis), drawn < 0 ? -size : size));
  }, from);
}

function span(a: Vec3, b: Vec3, axis: AxisName): number {
  return Math.round(dot(subtract(b, a), unitVector(axis)));
}
