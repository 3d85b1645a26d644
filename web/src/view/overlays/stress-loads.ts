import { ArrowHelper, Group, Vector3 } from 'three';
import type { PointLoad } from '../../model/stress.ts';
import type { OverlayContext, SceneOverlay } from './overlay.ts';

/** Modules that the arrow of the greatest force is long, and that any is at least. */
const LONGEST = 4;
const SHORTEST = 1.2;
const HEAD = 0.7;

/** An arrow that ends where each force acts. */
export class StressLoads implements SceneOverlay {
  readonly object = new Group();
  #context: OverlayContext | null = null;
  #loads: readonly PointLoad[] = [];

  setLoads(loads: readonly PointLoad[]): void {
    this.#loads = loads;
    this.#rebuild();
  }

  attach(context: OverlayContext): void {
    const themed = this.#context?.theme !== context.theme;
    this.#context = context;
    if (themed) {
      this.#rebuild();
    }
  }

  dispose(): void {
    this.#clear();
  }

  #rebuild(): void {
    this.#clear();
    const colour = this.#context?.theme.error ?? 0xd7342b;
    const forces = this.#loads.map(({ force }) => new Vector3(...force));
    const greatest = Math.max(...forces.map((force) => force.length()), 1e-9);
    this.#loads.forEach(({ at }, index) => {
      const force = forces[index];
      if (!force || force.length() === 0) {
        return;
      }
      const length = Math.max(SHORTEST, (LONGEST * force.length()) / greatest);
      const direction = force.clone().normalize();
      const from = new Vector3(...at).addScaledVector(direction, -length);
      const arrow = new ArrowHelper(direction, from, length, colour, HEAD, HEAD / 2);
      // Seen through bricks: the point of a load may be inside one.
      for (const part of [arrow.line, arrow.cone]) {
        part.renderOrder = 10;
        (Array.isArray(part.material) ? part.material : [part.material]).forEach((material) => {
          material.depthTest = false;
        });
      }
      this.object.add(arrow);
    });
    this.#context?.invalidate();
  }

  #clear(): void {
    for (const child of [...this.object.children]) {
      this.object.remove(child);
      if (child instanceof ArrowHelper) {
        child.dispose();
      }
    }
  }
}
