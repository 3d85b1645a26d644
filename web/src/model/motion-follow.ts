import { add, rotate, subtract, type Vec3 } from '../geometry/vec.ts';
import type { MovedPart } from './motion.ts';
import { transposed } from './motion-mix.ts';
import { isFullTurn, type Span, within } from './motion-span.ts';

// A point of a moving part, and the angle that brings it somewhere.

/** Where a point of a part lies when the part stands there. */
export function pointOf({ position, rotation }: MovedPart, local: Vec3): Vec3 {
  return add(position, rotate(rotation, local));
}

/** The point of a part, in its own frame, that lies at a place. */
export function localOf({ position, rotation }: MovedPart, at: Vec3): Vec3 {
  return rotate(transposed(rotation), subtract(at, position));
}

/** How far around where it stands a motion is looked through, and how finely, degrees. */
const REACH = 75;
const STEP = 3;
/** Of two angles that are as good, the nearer one: pixels for each degree. */
const STAY = 0.02;
const REFINEMENTS = 12;

/**
 * The angle at which something is least off, near the present one: what is dragged must not leap to the other side of
 * its way.
 * @param off how far off it is at an angle, CSS pixels.
 * @param gearing degrees of the motion for one of what is dragged.
 */
export function nearestAngle(
  span: Span,
  now: number,
  off: (degrees: number) => number,
  gearing = 1,
): number {
  const at = (turn: number) => now + turn * gearing;
  const cost = (turn: number) => off(within(span, at(turn))) + STAY * Math.abs(turn);
  const legal = (turn: number) =>
    isFullTurn(span) || (at(turn) >= span.from && at(turn) <= span.to);
  let best = 0;
  for (let turn = -REACH; turn <= REACH; turn += STEP) {
    if (legal(turn) && cost(turn) < cost(best)) {
      best = turn;
    }
  }
  let reach = STEP;
  for (let i = 0; i < REFINEMENTS; i++) {
    reach /= 2;
    const around = [best - reach, best + reach].filter(legal);
    best = around.reduce((a, b) => (cost(b) < cost(a) ? b : a), best);
  }
  return within(span, at(best));
}
