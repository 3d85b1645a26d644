import { type AxisName, add, axisIndex, rotate, type Vec3 } from '../geometry/vec.ts';
import type { Catalogue } from './catalogue.ts';
import type { Model } from './model.ts';
import type { SketchDocument } from './sketch.ts';

/** An axis-aligned box in modules; min <= max in each coordinate. */
export interface Bounds {
  readonly min: Vec3;
  readonly max: Vec3;
}

/** The smallest box around the points, or null when there is none. */
export function boundsOfPoints(points: Iterable<Vec3>): Bounds | null {
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  let any = false;
  for (const p of points) {
    any = true;
    for (let i = 0; i < 3; i++) {
      const value = p[i] ?? 0;
      min[i] = Math.min(min[i] ?? value, value);
      max[i] = Math.max(max[i] ?? value, value);
    }
  }
  return any ? { min, max } : null;
}

/** The smallest box around both; either may be null. */
export function unionBounds(a: Bounds | null, b: Bounds | null): Bounds | null {
  if (!a || !b) {
    return a ?? b;
  }
  return boundsOfPoints([a.min, a.max, b.min, b.max]);
}

/** Halfway through a box along an axis. */
export function middleAlong({ min, max }: Bounds, axis: AxisName): number {
  const k = axisIndex(axis);
  return (min[k] + max[k]) / 2;
}

/** The eight corners of a box. */
export function corners(box: Bounds): Vec3[] {
  const result: Vec3[] = [];
  for (let i = 0; i < 8; i++) {
    result.push([
      i & 1 ? box.max[0] : box.min[0],
      i & 2 ? box.max[1] : box.min[1],
      i & 4 ? box.max[2] : box.min[2],
    ]);
  }
  return result;
}

/** The corners of the boxes of all parts of a model that the catalogue knows. */
export function modelCorners(model: Model, catalogue: Catalogue): Vec3[] {
  return model.parts.flatMap((placed) => {
    const part = catalogue.find(placed.part);
    const box = part ? corners({ min: part.boundsMin, max: part.boundsMax }) : [];
    return box.map((corner) => add(rotate(placed.rotation, corner), placed.position));
  });
}

/** The box around all parts of a model that the catalogue knows, or null. */
export function modelBounds(model: Model, catalogue: Catalogue): Bounds | null {
  return boundsOfPoints(modelCorners(model, catalogue));
}

/** Ends of lines and shafts of a sketch, and corners of its keep-out boxes: what a picture of it is fitted to. */
export function sketchPoints(sketch: SketchDocument | null): readonly Vec3[] {
  return [
    ...(sketch?.lines ?? []).flatMap((line) => [line.from, line.to]),
    ...(sketch?.keepOut ?? []).flatMap((box) => [box.min, box.max]),
    ...(sketch?.shafts ?? []).flatMap((shaft) => [shaft.from, shaft.to]),
  ];
}

/** The box around all line ends of a sketch, or null when it has no line. */
export function sketchBounds(sketch: SketchDocument): Bounds | null {
  return boundsOfPoints(sketch.lines.flatMap((line) => [line.from, line.to]));
}
