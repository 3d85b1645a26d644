/** How far a drag looks to either side of where the motion stands, and how finely, degrees. */
const REACH = 75;
const STEP = 3;
const FINEST = 0.05;

/** From the least to the greatest angle that a motion has. */
export interface Span {
  readonly from: number;
  readonly to: number;
}

/** Whether a motion that goes on at one end comes in at the other. */
export function isFullTurn({ from, to }: Span): boolean {
  return to - from >= 359;
}

/** The angle within a span; over its ends where it is a full turn. */
export function within(span: Span, degrees: number): number {
  if (!isFullTurn(span)) {
    return Math.min(span.to, Math.max(span.from, degrees));
  }
  const size = span.to - span.from;
  return span.from + ((((degrees - span.from) % size) + size) % size);
}

/**
 * The angle at which something lies nearest to the pointer: the least of a function of one angle, not far from where
 * the motion stands, so that a linkage follows and does not leap to another of its poses.
 * @param miss how far off it is at an angle of the span.
 */
export function nearestAngle(span: Span, now: number, miss: (degrees: number) => number): number {
  let best = within(span, now);
  let least = miss(best);
  const look = (degrees: number) => {
    const angle = within(span, degrees);
    const off = miss(angle);
    if (off < least - 1e-9) {
      [best, least] = [angle, off];
    }
  };
  for (let by = STEP; by <= REACH; by += STEP) {
    look(now + by);
    look(now - by);
  }
  for (let step = STEP / 2; step > FINEST; step /= 2) {
    const middle = best;
    look(middle + step);
    look(middle - step);
  }
  return best;
}
