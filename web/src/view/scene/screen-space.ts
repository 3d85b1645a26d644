import {
  Matrix4,
  type OrthographicCamera,
  type PerspectiveCamera,
  Raycaster,
  Vector2,
  Vector4,
} from 'three';
import type { Vec3 } from '../../geometry/vec.ts';
import type { Projected, Ray } from '../view-types.ts';

/** Goes between places on a canvas (CSS pixels from its top left corner) and points of space. */
export class ScreenSpace {
  readonly #canvas: HTMLCanvasElement;
  readonly #camera: () => PerspectiveCamera | OrthographicCamera;
  readonly #raycaster = new Raycaster();

  constructor(canvas: HTMLCanvasElement, camera: () => PerspectiveCamera | OrthographicCamera) {
    this.#canvas = canvas;
    this.#camera = camera;
  }

  /** Size of the canvas, at least one pixel. */
  size(): { width: number; height: number } {
    return {
      width: Math.max(1, this.#canvas.clientWidth),
      height: Math.max(1, this.#canvas.clientHeight),
    };
  }

  /** The ray through a place on screen. */
  toRay(x: number, y: number): Ray {
    const camera = this.#camera();
    camera.updateMatrixWorld();
    const { width, height } = this.size();
    const place = new Vector2((x / width) * 2 - 1, 1 - (y / height) * 2);
    this.#raycaster.setFromCamera(place, camera);
    const { origin, direction } = this.#raycaster.ray;
    return {
      origin: [origin.x, origin.y, origin.z],
      direction: [direction.x, direction.y, direction.z],
    };
  }

  /** Where a point of space is on screen. */
  project(point: Vec3): Projected {
    return this.projector()(point);
  }

  /** project() for many points of one moment: the camera is asked once. */
  projector(): (point: Vec3) => Projected {
    const camera = this.#camera();
    camera.updateMatrixWorld();
    const { width, height } = this.size();
    const toClip = new Matrix4().multiplyMatrices(
      camera.projectionMatrix,
      camera.matrixWorldInverse,
    );
    const place = new Vector4();
    return ([x, y, z]) => {
      place.set(x, y, z, 1).applyMatrix4(toClip);
      const scale = place.w > 0 ? 1 / place.w : 1;
      return {
        x: ((place.x * scale + 1) / 2) * width,
        y: ((1 - place.y * scale) / 2) * height,
        visible: place.w > 0 && Math.abs(place.z) <= place.w,
      };
    };
  }
}
