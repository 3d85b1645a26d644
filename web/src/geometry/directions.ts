import { axesOf, type Plane } from './plane.ts';
import { add, scale, unitVector, type Vec3 } from './vec.ts';

/** A direction in a plane in which lines of whole length end well. */
export interface Direction {
  /** Unit length. */
  readonly along: Vec3;
  /** Lines run a whole number of these, in modules. */
  readonly step: number;
  /** One step, in whole numbers where the direction has them, so that no rounding creeps in. */
  readonly stepVector: Vec3;
}

/** Legs and hypotenuse of the right triangles that people build: 3-4-5 and its next three kin. */
const TRIPLES: readonly (readonly [number, number, number])[] = [
  [3, 4, 5],
  [5, 12, 13],
  [8, 15, 17],
  [7, 24, 25],
];

const SIGNS: readonly (readonly [number, number])[] = [
  [1, 1],
  [1, -1],
  [-1, 1],
  [-1, -1],
];

const HALF = 0.5;
const HALF_ROOT_3 = Math.sqrt(3) / 2;

/** Both ways along both axes of the plane. */
export function axisDirections(plane: Plane): Direction[] {
  return [
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ].map(([a = 0, b = 0]) => direction(plane, [a, b], 1));
}

/** All slopes of whole-numbered right triangles, steps ending at whole-numbered points. */
export function pythagoreanDirections(plane: Plane): Direction[] {
  return TRIPLES.flatMap(([a, b, c]) =>
    SIGNS.flatMap(([s, t]) => [
      direction(plane, [s * a, t * b], c),
      direction(plane, [s * b, t * a], c),
    ]),
  );
}

/** The directions of triangles and hexagons: 30 and 60 degrees from the axes of the plane. */
export function sixtyDirections(plane: Plane): Direction[] {
  return SIGNS.flatMap(([s, t]) => [
    direction(plane, [s * HALF, t * HALF_ROOT_3], 1),
    direction(plane, [s * HALF_ROOT_3, t * HALF], 1),
  ]);
}

/** `steps` of a direction from a point. */
export function walk(from: Vec3, way: Direction, steps: number): Vec3 {
  return add(from, scale(way.stepVector, steps));
}

function direction(plane: Plane, [a, b]: readonly [number, number], step: number): Direction {
  const [first, second] = axesOf(plane);
  const stepVector = add(scale(unitVector(first), a), scale(unitVector(second), b));
  return { along: scale(stepVector, 1 / step), step, stepVector };
}
