import type { DrawnPath, PlanePoint } from './linkage-answer.ts';

/** Paths to begin with, for those who do not draw by hand. */
export type PathShape = 'foot' | 'line' | 'ellipse';

const STEPS = 48;
const NEAR_ENDS = 0.25;

/** The half ellipse of a step over its straight sole; a straight line; an ellipse. Modules. */
export function pathOfShape(shape: PathShape): Pick<DrawnPath, 'points' | 'closed' | 'kind'> {
  switch (shape) {
    case 'foot':
      return { points: footPoints(8, 2.4), closed: true, kind: 'foot' };
    case 'line':
      return { points: linePoints(8), closed: false, kind: 'line' };
    case 'ellipse':
      return { points: ellipsePoints(4, 2), closed: true, kind: 'any' };
  }
}

function footPoints(length: number, lift: number): PlanePoint[] {
  const arc = Array.from({ length: STEPS }, (_, i): PlanePoint => {
    const angle = (Math.PI * i) / STEPS;
    return [(length / 2) * Math.cos(angle), lift * Math.sin(angle)];
  });
  const sole = Array.from(
    { length: STEPS },
    (_, i): PlanePoint => [-length / 2 + (length * i) / STEPS, 0],
  );
  return [...arc, ...sole];
}

function linePoints(length: number): PlanePoint[] {
  return Array.from({ length: 9 }, (_, i): PlanePoint => [(length * i) / 8 - length / 2, 0]);
}

function ellipsePoints(a: number, b: number): PlanePoint[] {
  return Array.from({ length: STEPS }, (_, i): PlanePoint => {
    const angle = (2 * Math.PI * i) / STEPS;
    return [a * Math.cos(angle), b * Math.sin(angle)];
  });
}

/** Whether a drawn stroke comes back to where it began: within a quarter of its extent. */
export function comesBack(points: readonly PlanePoint[]): boolean {
  const first = points[0];
  const last = points.at(-1);
  if (!first || !last || points.length < 8) {
    return false;
  }
  const extent = Math.max(...points.map(([u, v]) => Math.hypot(u - first[0], v - first[1])));
  return Math.hypot(last[0] - first[0], last[1] - first[1]) < NEAR_ENDS * extent;
}
