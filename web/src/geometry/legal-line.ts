import { AXIS_NAMES, type AxisName, length, subtract, type Vec3 } from './vec.ts';

/** Lines as long as this close to a whole number are whole: rounded drawings, before they are read. */
export const WHOLE = 1e-3;

/** The whole number of modules that a span is long, at least 1; null when it is not. */
export function wholeLength(span: Vec3): number | null {
  const whole = Math.round(length(span));
  return whole >= 1 && Math.abs(length(span) - whole) <= WHOLE ? whole : null;
}

/** True when a line with this span lies in a plane parallel to XY, YZ or ZX. */
export function isPlanar(span: Vec3): boolean {
  return span.some((value) => Math.abs(value) <= WHOLE);
}

/** Whether a line between the points has whole length and lies in a plane that can be built. */
export function isLegalLine(from: Vec3, to: Vec3): boolean {
  const span = subtract(to, from);
  return wholeLength(span) !== null && isPlanar(span);
}

/** The axis that the line runs along, or null. */
export function axisOf(from: Vec3, to: Vec3): AxisName | null {
  const span = subtract(to, from);
  const along = AXIS_NAMES.filter((_, k) => Math.abs(span[k] ?? 0) > WHOLE);
  return along.length === 1 ? (along[0] ?? null) : null;
}
