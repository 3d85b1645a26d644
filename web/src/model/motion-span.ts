/** From the least to the greatest angle that a motion has. */
export interface Span {
  readonly from: number;
  readonly to: number;
  /** Whether the greatest is the least again; where it is left out, a full turn is. */
  readonly round?: boolean;
}

/** The angles that a motion has. */
export function spanOf(path: {
  readonly angles: readonly number[];
  readonly round?: boolean;
}): Span {
  const { angles, round } = path;
  const ends = { from: angles[0] ?? 0, to: angles.at(-1) ?? 0 };
  return round === undefined ? ends : { ...ends, round };
}

/** Whether a motion that goes on at one end comes in at the other. */
export function isFullTurn({ from, to, round }: Span): boolean {
  return round ?? to - from >= 359;
}

/** The angle within a span; over its ends where it is a full turn. */
export function within(span: Span, degrees: number): number {
  if (!isFullTurn(span)) {
    return Math.min(span.to, Math.max(span.from, degrees));
  }
  const size = span.to - span.from;
  return span.from + ((((degrees - span.from) % size) + size) % size);
}
