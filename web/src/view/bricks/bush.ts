import type { Part, Prism } from '../../model/catalogue.ts';
import { type Detail, DIMENSIONS } from './detail.ts';
import { addAxleHole, axleHoleOpening } from './holes.ts';
import { frameAlong, type MeshBuilder, type Point2, reversed } from './mesh-builder.ts';
import { addPolygon } from './plate.ts';
import { addRevolved, fullCircle } from './revolve.ts';

/** Outline of a bush with two flanges: radius and height, from the middle to one end. */
const FLANGE = { waistRadius: 0.37, waistHeight: 0.22, edge: 0.03 } as const;

/** True for a bush of full length, which has a flange at both ends. */
export function hasFlanges(part: Part): boolean {
  return part.partClass === 'bush' && part.features.some((feature) => feature.length > 0.9);
}

/** Adds a bush: a sleeve with a flange at both ends about its axle hole. */
export function addBush(builder: MeshBuilder, part: Part, detail: Detail): void {
  const hole = part.features.find((feature) => feature.kind === 'axleHole');
  if (!hole) {
    return;
  }
  const frame = frameAlong(hole.center, hole.axis, hole.wing);
  const half = hole.length / 2;
  const { waistRadius, waistHeight, edge } = FLANGE;
  const rim = DIMENSIONS.bodyRadius;
  const upper: Point2[] = [
    [waistRadius, waistHeight],
    [rim, waistHeight],
    [rim, half - edge],
    [rim - edge, half],
  ];
  const lower = upper.map(([r, t]): Point2 => [r, -t]).reverse();
  addRevolved(builder, frame, [...lower, ...upper], {
    segments: detail.segments,
    rims: 'corners-and-ends',
    silhouettes: detail.silhouettes,
  });
  const face = fullCircle(detail.segments)
    .slice(0, -1)
    .map((a): Point2 => [(rim - edge) * Math.cos(a), (rim - edge) * Math.sin(a)]);
  for (const side of [frame, reversed(frame)]) {
    addPolygon(builder, side, { contour: face, holes: [axleHoleOpening(0, 0, 0)] }, half);
  }
  addAxleHole(builder, frame, half);
}

/** Adds the disc of an axle with a stop, or any other free collar. */
export function addStop(builder: MeshBuilder, collar: Prism, detail: Detail): void {
  const frame = frameAlong(collar.from, collar.axis);
  const { radius, halfThickness } = collar;
  addRevolved(
    builder,
    frame,
    [
      [0, -halfThickness],
      [radius, -halfThickness],
      [radius, halfThickness],
      [0, halfThickness],
    ],
    { segments: detail.segments, rims: 'corners', silhouettes: detail.silhouettes },
  );
}
