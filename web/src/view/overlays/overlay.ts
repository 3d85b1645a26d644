import type { Object3D } from 'three';
import type { Catalogue } from '../../model/catalogue.ts';
import type { Model } from '../../model/model.ts';
import type { ViewTheme } from '../scene/theme.ts';

/** What an overlay may know of the scene that it is in. */
export interface OverlayContext {
  readonly theme: ViewTheme;
  readonly model: Model | null;
  readonly catalogue: Catalogue;
  /** CSS pixels that one module takes at what is looked at. */
  readonly pixelsPerModule: number;
  /** Size of the picture, CSS pixels. */
  readonly width: number;
  readonly height: number;
  /** Asks for one more frame. */
  readonly invalidate: () => void;
}

/**
 * Something drawn over sketch and model that belongs to neither: arrows, rays, ghosts of a motion.
 * Positions are modules. Whoever makes one adds it with SceneView.addOverlay() and takes it away with
 * the function that this returns; the view disposes of what is still there when it ends.
 */
export interface SceneOverlay {
  readonly object: Object3D;
  /** Called when it has come into the scene, and again when theme, model or size have changed. */
  attach?(context: OverlayContext): void;
  /** Called before each frame; must not ask for frames without end. */
  update?(context: OverlayContext): void;
  /** Frees what it holds on the graphics card. */
  dispose(): void;
}
