import type { AxisName, Vec3 } from '../geometry/vec.ts';
import type { SketchDocument } from './sketch.ts';

/** A point of the plane that a path is drawn in, modules. */
export type PlanePoint = readonly [u: number, v: number];

/** What a path is for; see core/linkages/linkage_table.h. */
export type PathKind = 'any' | 'foot' | 'line';

/** A path as it is drawn. */
export interface DrawnPath {
  readonly points: readonly PlanePoint[];
  readonly closed: boolean;
  readonly kind: PathKind;
  /** The axis across the plane. */
  readonly normal: AxisName;
}

/** One linkage that draws the path. */
export interface LinkageAnswer {
  /** Millimetres, on average and at most. */
  readonly error: number;
  readonly largest: number;
  /** Degrees, at its worst. */
  readonly transmission: number;
  /** Crank, coupler, rocker, frame: modules. */
  readonly links: readonly [number, number, number, number];
  readonly pivots: readonly [PlanePoint, PlanePoint];
  /** Crank's pin, rocker's pin and drawing point over one turn. */
  readonly poses: readonly (readonly [number, number, number, number, number, number])[];
  readonly sketch: SketchDocument;
}

/** The path file (core/linkages/linkage_json.h) of what was drawn, through the origin. */
export function pathJson({ points, closed, kind, normal }: DrawnPath): string {
  const inSpace = ([u, v]: PlanePoint): Vec3 =>
    normal === 'x' ? [0, u, v] : normal === 'y' ? [u, 0, v] : [u, v, 0];
  return JSON.stringify({
    format: 'technic-path',
    version: 1,
    points: points.map(inSpace),
    closed,
    kind,
    plane: normal,
  });
}

/** The answers of the worker, whose text is our own core's. */
export function readAnswers(text: string): readonly LinkageAnswer[] {
  return (JSON.parse(text) as { answers: LinkageAnswer[] }).answers;
}
