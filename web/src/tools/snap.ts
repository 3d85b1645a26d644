import {
  AXIS_NAMES,
  type AxisName,
  add,
  distance,
  dot,
  lerp,
  scale,
  subtract,
  unitVector,
  type Vec3,
} from '../model/vec.ts';
import type { GuidePlane, ScreenPoint, SnapKind } from '../view/view-types.ts';
import { meetPlane, planeAxes, roundOnPlane } from './guide.ts';
import type { ToolView } from './tool.ts';

/** A place for the next point, and why it is there. */
export interface Located {
  readonly point: Vec3;
  readonly snap: SnapKind;
  /** The axis that a line from the last point runs along, if it runs along one. */
  readonly axis: AxisName | null;
}

/** A point that is near an existing node is drawn to it within so many pixels. */
const NODE_PIXELS = 12;
/** The axis that leaves the plane wins only when the pointer is right on it. */
const OFF_PLANE_PIXELS = 7;
/** An end that lies on an axis is nearer by this factor than one that does not. */
const AXIS_PULL = 0.55;
/** How far from the pointer a Pythagorean or 60-degree end may lie, in modules. */
const SKEW_REACH = 0.75;
const LENGTH_TOLERANCE = 0.02;

/** Whether a line between the points has whole length and lies in a plane that can be built. */
export function isLegalLine(from: Vec3, to: Vec3): boolean {
  const length = distance(from, to);
  const whole =
    Math.abs(length - Math.round(length)) <= LENGTH_TOLERANCE && Math.round(length) >= 1;
  return whole && from.some((value, k) => Math.abs(value - (to[k] ?? 0)) < LENGTH_TOLERANCE);
}

/** The axis that the line runs along, or null. */
export function axisOf(from: Vec3, to: Vec3): AxisName | null {
  const d = subtract(to, from);
  const along = AXIS_NAMES.filter((_, k) => Math.abs(d[k] ?? 0) > LENGTH_TOLERANCE);
  return along.length === 1 ? (along[0] ?? null) : null;
}

/** A place for a point that no length binds: a node near the pointer, else the plane's unit grid. */
export function locateFree(view: ToolView, at: ScreenPoint, plane: GuidePlane): Located | null {
  const node = view.pickAt(at).node;
  if (node && node.distance <= NODE_PIXELS) {
    return { point: node.at, snap: node.kind === 'inner' ? 'node' : 'end', axis: null };
  }
  const hit = meetPlane(view.rayAt(at), plane);
  return hit ? { point: roundOnPlane(hit, plane), snap: 'grid', axis: null } : null;
}

/** A place for a corner opposite to `start` on the plane: whole steps from it. */
export function locateCorner(
  view: ToolView,
  at: ScreenPoint,
  plane: GuidePlane,
  start: Vec3,
): Located | null {
  const hit = meetPlane(view.rayAt(at), plane);
  return hit ? { point: wholeSteps(start, hit), snap: 'grid', axis: null } : null;
}

/** Whole modules from `start` along one axis, nearest to the pointer on screen. */
export function locateAlong(
  view: ToolView,
  at: ScreenPoint,
  start: Vec3,
  axis: AxisName,
): Located | null {
  const steps = Math.round(axisParameter(view, at, start, axis));
  return steps === 0
    ? null
    : { point: add(start, scale(unitVector(axis), steps)), snap: 'axis', axis };
}

/** What the end of a line is found from. */
export interface LineStart {
  readonly from: Vec3;
  readonly lock: AxisName | null;
}

/**
 * A place for the end of a line from `start`: always of whole length, in a plane parallel to XY, YZ
 * or ZX. Nodes win over axes, axes over Pythagorean and 60-degree ends.
 */
export function locateEnd(
  view: ToolView,
  at: ScreenPoint,
  plane: GuidePlane,
  start: LineStart,
): Located | null {
  const { from, lock } = start;
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
  const hit = meetPlane(view.rayAt(at), { ...plane, through: from });
  return hit ? nearestWholeEnd(from, hit, plane) : offPlane;
}

/** The end of whole length on the plane nearest to `raw`, axes preferred. Null at the start itself. */
export function nearestWholeEnd(from: Vec3, raw: Vec3, plane: GuidePlane): Located | null {
  let best: Located | null = null;
  let bestCost = Infinity;
  const offer = (point: Vec3, snap: SnapKind, cost: number) => {
    if (cost < bestCost) {
      bestCost = cost;
      best = { point, snap, axis: axisOf(from, point) };
    }
  };
  for (const axis of planeAxes(plane.axis)) {
    const unit = unitVector(axis);
    const steps = Math.round(dot(subtract(raw, from), unit));
    if (steps !== 0) {
      const end = add(from, scale(unit, steps));
      offer(end, 'axis', distance(end, raw) * AXIS_PULL);
    }
  }
  for (const end of skewEnds(from, raw, plane)) {
    const gap = distance(end.point, raw);
    if (gap <= SKEW_REACH) {
      offer(end.point, end.snap, gap);
    }
  }
  return best;
}

function skewEnds(from: Vec3, raw: Vec3, plane: GuidePlane): { point: Vec3; snap: SnapKind }[] {
  const [first, second] = planeAxes(plane.axis);
  const u = unitVector(first);
  const v = unitVector(second);
  const d = subtract(raw, from);
  const at = (a: number, b: number) => add(from, add(scale(u, a), scale(v, b)));
  const ends: { point: Vec3; snap: SnapKind }[] = [];
  const a0 = Math.round(dot(d, u));
  const b0 = Math.round(dot(d, v));
  for (let a = a0 - 1; a <= a0 + 1; a++) {
    for (let b = b0 - 1; b <= b0 + 1; b++) {
      if (a !== 0 && b !== 0 && Number.isInteger(Math.hypot(a, b))) {
        ends.push({ point: at(a, b), snap: 'pythagorean' });
      }
    }
  }
  const length = Math.round(Math.hypot(dot(d, u), dot(d, v)));
  const half = length / 2;
  const long = (length * Math.sqrt(3)) / 2;
  for (const [a, b] of [
    [half, long],
    [long, half],
  ] as const) {
    const point = at(a * Math.sign(dot(d, u)), b * Math.sign(dot(d, v)));
    if (length >= 1) {
      ends.push({ point, snap: 'sixty' });
    }
  }
  return ends;
}

function wholeSteps(start: Vec3, p: Vec3): Vec3 {
  const step = (k: number) => (start[k] ?? 0) + Math.round((p[k] ?? 0) - (start[k] ?? 0));
  return [step(0), step(1), step(2)];
}

/** Modules from `start` along the axis to the point that is nearest to the pointer's ray. */
function axisParameter(view: ToolView, at: ScreenPoint, start: Vec3, axis: AxisName): number {
  const ray = view.rayAt(at);
  const u = unitVector(axis);
  const w = subtract(start, ray.origin);
  const b = dot(u, ray.direction);
  const slope = 1 - b * b;
  if (slope < 1e-4) {
    return 0;
  }
  return (b * dot(w, ray.direction) - dot(w, u)) / slope;
}

function pixelsOffAxis(view: ToolView, at: ScreenPoint, start: Vec3, axis: AxisName): number {
  const nearest = add(start, scale(unitVector(axis), axisParameter(view, at, start, axis)));
  const shown = view.project(nearest);
  return shown.visible ? Math.hypot(shown.x - at.x, shown.y - at.y) : Infinity;
}

/** The end that a typed length gives: as far along the present direction. */
export function endAtLength(from: Vec3, toward: Vec3, length: number): Vec3 {
  const now = distance(from, toward);
  return now === 0 ? from : lerp(from, toward, length / now);
}
