import type { Object3D } from 'three';
import type { Vec3 } from '../../geometry/vec.ts';
import type { SketchDocument, SketchNode } from '../../model/sketch.ts';
import type { ViewTheme } from '../scene/theme.ts';
import type { GuidePlane, LinePreview, SketchMarks } from '../view-types.ts';
import { GuidePlaneLayer } from './guide-plane-layer.ts';
import { PreviewLayer } from './preview-layer.ts';
import { SketchLayer } from './sketch-layer.ts';

/** How the sketch lies in each mode. */
export const SKETCH_OVERLAY = { sketch: 'within', both: 'over', model: null } as const;

/** Everything of drawing: the sketch, the plane that is drawn on, and the line under way. */
export class SketchScene {
  readonly #sketch = new SketchLayer();
  readonly #guide = new GuidePlaneLayer();
  readonly #preview = new PreviewLayer();
  #marks: SketchMarks = {};
  #previewLine: LinePreview | null = null;
  #theme: ViewTheme;

  constructor(theme: ViewTheme) {
    this.#theme = theme;
  }

  get objects(): readonly Object3D[] {
    return [this.#sketch.group, this.#guide.group, this.#preview.group];
  }

  get sketch(): SketchDocument | null {
    return this.#sketch.sketch;
  }

  /** Nodes of the present sketch, for picking. */
  get nodes(): readonly SketchNode[] {
    return this.#sketch.nodes;
  }

  /** @returns whether it is another sketch than before. */
  set(sketch: SketchDocument | null, marks: SketchMarks): boolean {
    const changed = sketch !== this.#sketch.sketch;
    this.#marks = marks;
    this.#sketch.set(sketch, marks, this.#theme);
    return changed;
  }

  setGuidePlane(plane: GuidePlane | null, cursor: Vec3 | null): void {
    this.#guide.set(plane, cursor);
  }

  setPreview(preview: LinePreview | null): void {
    this.#previewLine = preview;
    this.#preview.set(preview, this.#theme);
  }

  setTheme(theme: ViewTheme): void {
    this.#theme = theme;
    this.#guide.setTheme(theme);
    this.#sketch.set(this.#sketch.sketch, this.#marks, theme);
    this.#preview.set(this.#previewLine, theme);
  }

  /** @param overlay null hides the sketch. */
  setOverlay(overlay: 'over' | 'within' | null): void {
    this.#sketch.group.visible = overlay !== null;
    if (overlay) {
      this.#sketch.setOverlay(overlay);
    }
  }

  setResolution(width: number, height: number, pixelRatio: number): void {
    this.#sketch.setResolution(width, height, pixelRatio);
    this.#preview.setResolution(width, height, pixelRatio);
  }

  dispose(): void {
    this.#sketch.dispose();
    this.#guide.dispose();
    this.#preview.dispose();
  }
}
