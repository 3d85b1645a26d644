import {
  add,
  distance,
  dominantAxis,
  dot,
  length,
  normalize,
  samePoint,
  scale,
  subtract,
  type Vec3,
} from '../../geometry/vec.ts';
import { type Feature, isHole, type Part, type Prism } from '../../model/catalogue.ts';
import { DIMENSIONS } from './detail.ts';

/** Points closer than this are one, modules. */
export const TOLERANCE = 0.02;
/** A hole this near to a prism's middle line goes through it. */
const PIERCED = 0.3;
/** A hole this near to it lies in its middle. */
const CENTRED = 0.1;
/** A hole across a prism cuts into it from this far beyond its faces. */
const HOLE_HALF = 0.2;

/** The bodies of a part that are drawn as plates and barrels; axes point to their positive side. */
export function bodyPrisms(part: Part): Prism[] {
  const holes = part.features.filter((feature) => isHole(feature.kind));
  return mergeTubes(withHoleBodies(usablePrisms(part, holes), holes));
}

/** Distance from a point to the segment a-b. */
export function distanceToSegment(p: Vec3, a: Vec3, b: Vec3): number {
  const along = subtract(b, a);
  const size = dot(along, along);
  const t = size > 0 ? Math.min(1, Math.max(0, dot(subtract(p, a), along) / size)) : 0;
  return distance(p, add(a, scale(along, t)));
}

/**
 * The prisms of the solid that can be drawn with their holes open. The solid is made for collision
 * checks, where a hole needs no opening: webs and necks in it would close holes that cross them, so
 * they are left out here and drawn as bridges.
 */
function usablePrisms(part: Part, holes: readonly Feature[]): Prism[] {
  const usable = part.solid.filter((prism) => {
    const along = holes.filter((hole) => parallel(hole.axis, prism.axis));
    const own = along.filter((hole) => holds(prism, hole, CENTRED));
    const blocked = holes.some(
      (hole) =>
        !own.includes(hole) && holds(prism, hole, PIERCED, along.includes(hole) ? 0 : HOLE_HALF),
    );
    return !blocked && (own.length > 0 || holes.length === 0);
  });
  const turned = usable.map((prism) => ({ ...prism, axis: positive(normalize(prism.axis)) }));
  return turned.filter((prism) => !turned.some((other) => covers(other, prism)));
}

/**
 * True when the middle of the hole, or of one of its slots, is less than `reach` off the prism's
 * middle line and at most `over` above or below the prism.
 */
function holds(prism: Prism, hole: Feature, reach: number, over = 0): boolean {
  return [hole.center, ...hole.slots].some((point) => {
    const height = dot(subtract(point, prism.from), prism.axis);
    const flat = subtract(point, scale(prism.axis, height));
    return (
      Math.abs(height) < prism.halfThickness + over &&
      distanceToSegment(flat, prism.from, prism.to) < reach
    );
  });
}

/** True when a barrel is a place of a longer body of the same height. */
function covers(long: Prism, barrel: Prism): boolean {
  return (
    isPoint(barrel) &&
    !isPoint(long) &&
    parallel(long.axis, barrel.axis) &&
    Math.abs(long.halfThickness - barrel.halfThickness) < TOLERANCE &&
    distanceToSegment(barrel.from, long.from, long.to) < TOLERANCE
  );
}

/** The bodies, and a barrel round each hole that none of them holds. */
function withHoleBodies(bodies: readonly Prism[], holes: readonly Feature[]): Prism[] {
  const bare = holes.filter(
    (hole) =>
      !bodies.some((prism) => parallel(prism.axis, hole.axis) && holds(prism, hole, CENTRED)),
  );
  return [
    ...bodies,
    ...bare.map((hole) => ({
      from: hole.center,
      to: hole.center,
      axis: positive(normalize(hole.axis)),
      radius: DIMENSIONS.bodyRadius,
      halfThickness: hole.length / 2,
    })),
  ];
}

/** A barrel: a prism whose middle line is one point. */
export function isPoint(prism: Prism): boolean {
  return samePoint(prism.from, prism.to, TOLERANCE);
}

function positive(axis: Vec3): Vec3 {
  return axis[dominantAxis(axis)] < 0 ? scale(axis, -1) : axis;
}

/** True for directions along one line, either way. */
export function parallel(a: Vec3, b: Vec3): boolean {
  return Math.abs(dot(a, b)) > 1 - 1e-3;
}

/** Barrels that stand on one another along their axis become one longer barrel. */
function mergeTubes(prisms: readonly Prism[]): Prism[] {
  const rest = [...prisms];
  const merged: Prism[] = [];
  for (let prism = rest.shift(); prism; prism = rest.shift()) {
    let grown = prism;
    let index = isPoint(prism) ? rest.findIndex((other) => stacks(grown, other)) : -1;
    while (index >= 0) {
      grown = stacked(grown, rest.splice(index, 1)[0] ?? grown);
      index = rest.findIndex((other) => stacks(grown, other));
    }
    merged.push(grown);
  }
  return merged;
}

function stacks(a: Prism, b: Prism): boolean {
  if (!isPoint(b) || !parallel(a.axis, b.axis) || Math.abs(a.radius - b.radius) > TOLERANCE) {
    return false;
  }
  const offset = subtract(b.from, a.from);
  const along = dot(offset, a.axis);
  const across = length(subtract(offset, scale(a.axis, along)));
  const gap = Math.abs(along) - a.halfThickness - b.halfThickness;
  return across < TOLERANCE && Math.abs(gap) < TOLERANCE;
}

function stacked(a: Prism, b: Prism): Prism {
  const along = dot(subtract(b.from, a.from), a.axis);
  const low = Math.min(-a.halfThickness, along - b.halfThickness);
  const high = Math.max(a.halfThickness, along + b.halfThickness);
  const middle = add(a.from, scale(a.axis, (low + high) / 2));
  return { ...a, from: middle, to: middle, halfThickness: (high - low) / 2 };
}
