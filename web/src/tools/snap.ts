import { axisOf, isLegalLine } from '../geometry/legal-line.ts';
import { nearestAlongAxis } from '../geometry/plane.ts';
import { legalEnds, type SnapReason, snapEnd } from '../geometry/snap-end.ts';
import {
  AXIS_NAMES,
  type AxisName,
  add,
  distance,
  lerp,
  scale,
  unitVector,
  type Vec3,
} from '../geometry/vec.ts';
import type { SketchLine } from '../model/sketch.ts';
import type { GuidePlane, ScreenPoint, SnapKind } from '../view/view-types.ts';
import { meetGuide } from './guide.ts';
import type { ToolView } from './tool.ts';

/** A place for the next point, and why it is there. */
export interface Located {
  readonly point: Vec3;
  readonly snap: SnapKind;
  /** The axis that a line from the last point runs along, if it runs along one. */
  readonly axis: AxisName | null;
  /** Other places round the pointer where it could be. */
  readonly others?: readonly Vec3[];
}

/** A point is drawn to an existing node, wherever it is in depth, within so many pixels. */
const NODE_PIXELS = 12;
/** The axis that leaves the plane wins only when the pointer is right on it. */
const OFF_PLANE_PIXELS = 7;
/** How far from the pointer an end off the axes may be: pixels, but within these modules. */
const REACH = { pixels: 16, least: 0.45, most: 1.2 } as const;

/** Ends that could be chosen are shown so far from the pointer, modules. */
const OTHERS_WITHIN = 2.6;

/** The view's word for the geometry's. */
const KINDS: Readonly<Record<SnapReason, SnapKind>> = {
  endpoint: 'end',
  node: 'node',
  axis: 'axis',
  plane: 'grid',
  parallel: 'in-line',
  pythagorean: 'pythagorean',
  sixty: 'sixty',
};

/** A place for a point that no length binds: a node near the pointer, else the plane's unit grid. */
export function locateFree(view: ToolView, at: ScreenPoint, plane: GuidePlane): Located | null {
  const node = view.pickAt(at).node;
  if (node && node.distance <= NODE_PIXELS) {
    return { point: node.at, snap: node.kind === 'inner' ? 'node' : 'end', axis: null };
  }
  const cursor = meetGuide(view.rayAt(at), plane);
  if (!cursor) {
    return null;
  }
  const { point } = snapEnd({
    start: null,
    plane: { normal: plane.axis, through: plane.through },
    lines: [],
    lockAxis: null,
    cursor,
    tolerance: REACH.least,
  });
  return { point, snap: 'grid', axis: null };
}

/** A place for a corner opposite to `start` on the plane: whole steps from it. */
export function locateCorner(
  view: ToolView,
  at: ScreenPoint,
  plane: GuidePlane,
  start: Vec3,
): Located | null {
  const hit = meetGuide(view.rayAt(at), plane);
  return hit ? { point: wholeSteps(start, hit), snap: 'grid', axis: null } : null;
}

/** Whole modules from `start` along one axis, nearest to the pointer on screen. */
export function locateAlong(
  view: ToolView,
  at: ScreenPoint,
  start: Vec3,
  axis: AxisName,
): Located | null {
  const steps = Math.round(nearestAlongAxis(view.rayAt(at), start, axis) ?? 0);
  return steps === 0
    ? null
    : { point: add(start, scale(unitVector(axis), steps)), snap: 'axis', axis };
}

/** What the end of a line is found from. */
export interface LineStart {
  readonly from: Vec3;
  readonly lock: AxisName | null;
  /** The lines drawn so far. */
  readonly lines: readonly SketchLine[];
}

/**
 * A place for the end of a line from `start`: always of whole length, in a plane parallel to XY, YZ
 * or ZX. A node under the pointer wins at any depth; then the axis that leaves the plane, when the
 * pointer is right on it; then what lies on the plane.
 */
export function locateEnd(
  view: ToolView,
  at: ScreenPoint,
  plane: GuidePlane,
  start: LineStart,
): Located | null {
  const { from, lock, lines } = start;
  if (lock) {
    return locateAlong(view, at, from, lock);
  }
  const node = view.pickAt(at).node;
  if (node && node.distance <= NODE_PIXELS && isLegalLine(from, node.at)) {
    const snap = node.kind === 'inner' ? 'node' : 'end';
    return { point: node.at, snap, axis: axisOf(from, node.at) };
  }
  const offPlane = locateAlong(view, at, from, plane.axis);
  if (offPlane && pixelsOffAxis(view, at, from, plane.axis) <= OFF_PLANE_PIXELS) {
    return offPlane;
  }
  const cursor = meetGuide(view.rayAt(at), { ...plane, through: from });
  if (!cursor) {
    return offPlane;
  }
  const context = {
    start: from,
    plane: { normal: plane.axis, through: from },
    lines,
    lockAxis: null,
    cursor,
    tolerance: reachAt(view, cursor),
  };
  const { point, reason } = snapEnd(context);
  const others = legalEnds(context, OTHERS_WITHIN);
  return { point, snap: KINDS[reason], axis: axisOf(from, point), others };
}

/** The end that a typed length gives: as far along the present direction. */
export function endAtLength(from: Vec3, toward: Vec3, length: number): Vec3 {
  const now = distance(from, toward);
  return now === 0 ? from : lerp(from, toward, length / now);
}

function wholeSteps(start: Vec3, p: Vec3): Vec3 {
  const step = (k: number) => (start[k] ?? 0) + Math.round((p[k] ?? 0) - (start[k] ?? 0));
  return [step(0), step(1), step(2)];
}

function pixelsOffAxis(view: ToolView, at: ScreenPoint, start: Vec3, axis: AxisName): number {
  const steps = nearestAlongAxis(view.rayAt(at), start, axis);
  if (steps === null) {
    return Infinity;
  }
  const shown = view.project(add(start, scale(unitVector(axis), steps)));
  return shown.visible ? Math.hypot(shown.x - at.x, shown.y - at.y) : Infinity;
}

/** Modules that some pixels are at a place. */
function reachAt(view: ToolView, place: Vec3): number {
  const here = view.project(place);
  const pixels = AXIS_NAMES.map((axis) => {
    const there = view.project(add(place, unitVector(axis)));
    return Math.hypot(there.x - here.x, there.y - here.y);
  });
  const modules = REACH.pixels / Math.max(1, ...pixels);
  return Math.min(REACH.most, Math.max(REACH.least, modules));
}
