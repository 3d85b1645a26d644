import { Group, Mesh, MeshBasicMaterial, SphereGeometry } from 'three';
import type { Vec3 } from '../../geometry/vec.ts';
import { ThickLines } from '../sketch/thick-lines.ts';
import type { OverlayContext, SceneOverlay } from './overlay.ts';

/** The way of a point, and where on it the point is now. */
export interface Trace {
  readonly points: readonly Vec3[];
  readonly now: Vec3;
  /** sRGB. */
  readonly colour: number;
}

const WIDTH = 3;
const DOT_RADIUS = 0.22;
/** Over bricks: a way goes through them. */
const ORDER = 12;

/** The ways of points of a motion. */
export class MotionTraces implements SceneOverlay {
  readonly object = new Group();
  readonly #lines = new ThickLines({ width: WIDTH, renderOrder: ORDER });
  readonly #sphere = new SphereGeometry(DOT_RADIUS, 16, 12);
  #dots: Mesh<SphereGeometry, MeshBasicMaterial>[] = [];
  #points: readonly (readonly Vec3[])[] = [];
  #invalidate: () => void = () => undefined;

  constructor() {
    this.#lines.setOverlay('over');
    this.object.add(this.#lines.object);
  }

  set(traces: readonly Trace[]): void {
    const same =
      traces.length === this.#points.length &&
      traces.every(({ points }, i) => points === this.#points[i]);
    if (!same) {
      this.#points = traces.map(({ points }) => points);
      this.#lines.set(traces.flatMap(segmentsOf));
      this.#setDots(traces);
    }
    traces.forEach(({ now }, i) => {
      this.#dots[i]?.position.set(...now);
    });
    this.#invalidate();
  }

  attach({ width, height, invalidate }: OverlayContext): void {
    this.#lines.setResolution(width, height);
    this.#invalidate = invalidate;
  }

  dispose(): void {
    this.#setDots([]);
    this.#lines.dispose();
    this.#sphere.dispose();
  }

  #setDots(traces: readonly Trace[]): void {
    for (const dot of this.#dots) {
      this.object.remove(dot);
      dot.material.dispose();
    }
    this.#dots = traces.map(({ colour }) => {
      const dot = new Mesh(
        this.#sphere,
        new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true }),
      );
      dot.renderOrder = ORDER + 1;
      return dot;
    });
    for (const dot of this.#dots) {
      this.object.add(dot);
    }
  }
}

function segmentsOf({ points, colour }: Trace) {
  return points.slice(1).map((to, i) => ({ from: points[i] ?? to, to, colour }));
}
