import { ShapeUtils, Vector2 } from 'three';
import type { Vec3 } from '../../geometry/vec.ts';
import {
  directionToPart,
  type Frame,
  type MeshBuilder,
  type Point2,
  toPart,
} from './mesh-builder.ts';
import { type BarGraph, type Outline, outlineBars, signedArea } from './outline.ts';

/** A flat body: bars of one height about a frame's xy plane, with openings through both faces. */
export interface PlateShape {
  readonly graph: BarGraph;
  readonly radius: number;
  /** Half the height along the frame's z axis. */
  readonly halfHeight: number;
  /** Closed polygons, counter-clockwise, that stay open in both faces. */
  readonly openings: readonly (readonly Point2[])[];
}

export interface PlateStyle {
  readonly segments: number;
  /** Width of the rounding along the rims, modules. */
  readonly rounding: number;
  readonly silhouettes: boolean;
}

/** Rims are drawn a little outside the rounding, where a round edge would have its crest. */
const LINE_INSET = 0.29;

/** Adds walls, rounded rims, both faces and the drawn lines of a plate; openings stay without walls. */
export function addPlate(
  builder: MeshBuilder,
  frame: Frame,
  shape: PlateShape,
  style: PlateStyle,
): void {
  const outer = outlineBars(shape.graph, shape.radius, style.segments);
  const inner =
    style.rounding > 0
      ? outlineBars(shape.graph, shape.radius - style.rounding, style.segments)
      : outer;
  const lineRadius = shape.radius - LINE_INSET * style.rounding;
  const lines = outlineBars(shape.graph, lineRadius, style.segments);
  const wallTop = shape.halfHeight - style.rounding;
  outer.forEach((outline, i) => {
    addWall(builder, frame, { outline, height: wallTop }, style.silhouettes);
    const rim = inner[i] ?? outline;
    for (const side of [1, -1] as const) {
      if (style.rounding > 0) {
        addRounding(builder, frame, { outline, rim }, [side * wallTop, side * shape.halfHeight]);
      }
      const line = lines[i] ?? rim;
      builder.hardPolyline(
        ring(frame, line, side * (shape.halfHeight - LINE_INSET * style.rounding)),
      );
    }
  });
  for (const side of [1, -1] as const) {
    addFace(builder, frame, { outlines: inner, openings: shape.openings }, side * shape.halfHeight);
  }
}

/** Walls between -height and +height of a closed outline, with its hard and silhouette lines. */
function addWall(
  builder: MeshBuilder,
  frame: Frame,
  wall: { readonly outline: Outline; readonly height: number },
  silhouettes: boolean,
): void {
  const { outline, height } = wall;
  outline.forEach((vertex, i) => {
    const next = outline[(i + 1) % outline.length] ?? vertex;
    const low = builder.vertex(at(frame, vertex.point, -height), normal(frame, vertex.after));
    builder.vertex(at(frame, next.point, -height), normal(frame, next.before));
    builder.vertex(at(frame, next.point, height), normal(frame, next.before));
    builder.vertex(at(frame, vertex.point, height), normal(frame, vertex.after));
    builder.quad(low, low + 1, low + 2, low + 3);
    addUprightLine(builder, frame, { outline, index: i, height }, silhouettes);
  });
}

/** The line up the wall at one outline vertex: hard at inner corners, else a silhouette. */
function addUprightLine(
  builder: MeshBuilder,
  frame: Frame,
  spot: { readonly outline: Outline; readonly index: number; readonly height: number },
  silhouettes: boolean,
): void {
  const { outline, index, height } = spot;
  const vertex = outline[index];
  if (!vertex) {
    return;
  }
  const a = at(frame, vertex.point, -height);
  const b = at(frame, vertex.point, height);
  const { before, after } = vertex;
  if (before[0] * after[0] + before[1] * after[1] < 0.9) {
    builder.hardLine(a, b);
  } else if (silhouettes) {
    const previous = outline[(index + outline.length - 1) % outline.length] ?? vertex;
    const next = outline[(index + 1) % outline.length] ?? vertex;
    builder.softLine(a, b, [
      normal(frame, middle(previous.after, before)),
      normal(frame, middle(after, next.before)),
    ]);
  }
}

/** A strip from the wall's end to the face's rim whose normals turn from one to the other. */
function addRounding(
  builder: MeshBuilder,
  frame: Frame,
  lines: { readonly outline: Outline; readonly rim: Outline },
  heights: readonly [number, number],
): void {
  const { outline, rim } = lines;
  const up = directionToPart(frame, 0, 0, Math.sign(heights[1]));
  outline.forEach((vertex, i) => {
    const j = (i + 1) % outline.length;
    const next = outline[j] ?? vertex;
    const rimVertex = rim[i] ?? vertex;
    const rimNext = rim[j] ?? next;
    const a = builder.vertex(at(frame, vertex.point, heights[0]), normal(frame, vertex.after));
    const b = builder.vertex(at(frame, next.point, heights[0]), normal(frame, next.before));
    const c = builder.vertex(at(frame, rimNext.point, heights[1]), up);
    const d = builder.vertex(at(frame, rimVertex.point, heights[1]), up);
    if (heights[1] > 0) {
      builder.quad(a, b, c, d);
    } else {
      builder.quad(b, a, d, c);
    }
  });
}

/** One face at the given height, triangulated round the openings; looks away from the middle. */
function addFace(
  builder: MeshBuilder,
  frame: Frame,
  figure: { readonly outlines: readonly Outline[]; readonly openings: PlateShape['openings'] },
  height: number,
): void {
  const loops = figure.outlines.map((outline) => ({
    points: outline.map((vertex) => vertex.point),
    area: signedArea(outline),
  }));
  const holes = [
    ...loops.filter((loop) => loop.area < 0).map((loop) => loop.points),
    ...figure.openings,
  ];
  for (const loop of loops.filter((candidate) => candidate.area > 0)) {
    addPolygon(builder, frame, { contour: loop.points, holes }, height);
  }
}

/** A flat polygon with holes at a height; its normal is +z above the middle, -z below. */
export function addPolygon(
  builder: MeshBuilder,
  frame: Frame,
  polygon: {
    readonly contour: readonly Point2[];
    readonly holes: readonly (readonly Point2[])[];
  },
  height: number,
): void {
  const toVectors = (points: readonly Point2[]): Vector2[] =>
    points.map(([x, y]) => new Vector2(x, y));
  const faces = ShapeUtils.triangulateShape(
    toVectors(polygon.contour),
    polygon.holes.map(toVectors),
  );
  const up = directionToPart(frame, 0, 0, height < 0 ? -1 : 1);
  const points = [...polygon.contour, ...polygon.holes.flat()];
  const first = points.map((point) => builder.vertex(at(frame, point, height), up))[0] ?? 0;
  for (const [a = 0, b = 0, c = 0] of faces) {
    const turned = turnsLeft(points, a, b, c) === height >= 0;
    builder.triangle(first + a, first + (turned ? b : c), first + (turned ? c : b));
  }
}

function turnsLeft(points: readonly Point2[], a: number, b: number, c: number): boolean {
  const [p, q, r] = [points[a], points[b], points[c]];
  if (!p || !q || !r) {
    return true;
  }
  return (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]) > 0;
}

function at(frame: Frame, point: Point2, height: number): Vec3 {
  return toPart(frame, point[0], point[1], height);
}

function normal(frame: Frame, direction: Point2): Vec3 {
  return directionToPart(frame, direction[0], direction[1], 0);
}

function middle(a: Point2, b: Point2): Point2 {
  const sum: Point2 = [a[0] + b[0], a[1] + b[1]];
  const size = Math.hypot(sum[0], sum[1]) || 1;
  return [sum[0] / size, sum[1] / size];
}

function ring(frame: Frame, outline: Outline, height: number): Vec3[] {
  const points = outline.map((vertex) => at(frame, vertex.point, height));
  const first = points[0];
  return first ? [...points, first] : points;
}
