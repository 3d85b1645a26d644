import { Vector3 } from 'three';
import { FIELD_OF_VIEW, fitPoints, PAGE_MARGINS } from '../../web/src/view/scene/fit-points.ts';
import { VIEW_DIRECTIONS } from '../../web/src/view/scene/standard-views.ts';
import type { StandardView } from '../../web/src/view/view-types.ts';

export type Point = readonly [number, number, number];

/** What an empty sketch is fitted to; as in the page. */
const EMPTY_BOX: readonly Point[] = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [
  i & 1 ? 6 : -6,
  i & 2 ? 6 : -6,
  i & 4 ? 5 : -1,
]);

/** Where points of space are on screen, for the orthographic camera after a standard view's fit. */
export class Camera {
  readonly #target: Vector3;
  readonly #right: Vector3;
  readonly #up: Vector3;
  readonly #height: number;
  readonly #box: { readonly width: number; readonly height: number };

  /**
   * @param shown ends of all lines on the page, empty for an empty page.
   * @param zoom what the picture was made larger by since the fit, below 1 for smaller.
   */
  constructor(
    view: StandardView,
    shown: readonly Point[],
    box: { readonly width: number; readonly height: number },
    zoom = 1,
  ) {
    const direction = new Vector3(...VIEW_DIRECTIONS[view]).normalize();
    const points = shown.length > 0 ? shown : EMPTY_BOX;
    const { target, away } = fitPoints(points, direction, box.width / box.height, PAGE_MARGINS);
    this.#box = box;
    this.#target = target;
    this.#right = new Vector3(0, 0, 1).cross(direction).normalize();
    this.#up = direction.clone().cross(this.#right).normalize();
    this.#height = (2 * away * Math.tan((FIELD_OF_VIEW * Math.PI) / 360)) / zoom;
  }

  /** Pixels from the middle of the drawing, y upwards. */
  at(point: Point): [number, number] {
    const offset = new Vector3(...point).sub(this.#target);
    const scale = this.#box.height / this.#height;
    return [offset.dot(this.#right) * scale, offset.dot(this.#up) * scale];
  }
}
