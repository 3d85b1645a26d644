import type { Vec3 } from '../../geometry/vec.ts';
import type { StandardView } from '../view-types.ts';

/** Directions from the middle to the eye. A little off the pole, so that up stays defined. */
export const VIEW_DIRECTIONS: Readonly<Record<StandardView, Vec3>> = {
  front: [0, -1, 0],
  back: [0, 1, 0],
  left: [-1, 0, 0],
  right: [1, 0, 0],
  top: [0, -0.0005, 1],
  bottom: [0, -0.0005, -1],
  iso: [0.62, -0.7, 0.46],
};
