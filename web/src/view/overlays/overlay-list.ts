import { Group } from 'three';
import type { OverlayContext, SceneOverlay } from './overlay.ts';

/** The overlays of a scene. */
export class OverlayList {
  readonly group = new Group();
  readonly #overlays = new Set<SceneOverlay>();
  readonly #context: () => OverlayContext;

  constructor(context: () => OverlayContext) {
    this.#context = context;
  }

  /** @returns what takes it away and disposes of it; calling it twice does no harm. */
  add(overlay: SceneOverlay): () => void {
    this.#overlays.add(overlay);
    this.group.add(overlay.object);
    overlay.attach?.(this.#context());
    return () => this.#remove(overlay);
  }

  /** Tells all that theme, model or size have changed. */
  refresh(): void {
    this.#each((overlay, context) => overlay.attach?.(context));
  }

  /** Before each frame. */
  update(): void {
    this.#each((overlay, context) => overlay.update?.(context));
  }

  dispose(): void {
    for (const overlay of [...this.#overlays]) {
      this.#remove(overlay);
    }
  }

  #each(act: (overlay: SceneOverlay, context: OverlayContext) => void): void {
    if (this.#overlays.size > 0) {
      const context = this.#context();
      for (const overlay of this.#overlays) {
        act(overlay, context);
      }
    }
  }

  #remove(overlay: SceneOverlay): void {
    if (this.#overlays.delete(overlay)) {
      this.group.remove(overlay.object);
      overlay.dispose();
      this.#context().invalidate();
    }
  }
}
