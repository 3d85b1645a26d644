import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import type { Vec3 } from '../../geometry/vec.ts';
import { boundsOfPoints, modelCorners } from '../../model/bounds.ts';
import type { Catalogue } from '../../model/catalogue.ts';
import type { PlacedPart } from '../../model/model.ts';
import { BrickLibrary } from '../bricks/brick-library.ts';
import { BrickMaterials } from '../bricks/brick-materials.ts';
import { chooseDetail } from '../level-of-detail.ts';
import { ModelLayer } from '../model-layer.ts';
import type { SceneOverlay } from '../overlays/overlay.ts';
import { OverlayList } from '../overlays/overlay-list.ts';
import { FIELD_OF_VIEW, fitPoints } from '../scene/fit-points.ts';
import { Stage } from '../scene/stage.ts';
import { VIEW_DIRECTIONS } from '../scene/standard-views.ts';
import { viewTheme } from '../scene/theme.ts';
import type { ColourScheme, PartDisplay, Projection, ThemeName } from '../view-types.ts';
import { canvasToPng } from './canvas-png.ts';

/** One picture of some parts. */
export interface StillOptions {
  readonly parts: readonly PlacedPart[];
  /** Pixels of the picture. */
  readonly width: number;
  readonly height: number;
  readonly theme?: ThemeName;
  readonly colourBy?: ColourScheme;
  /** Colours, poses, looks and highlights by index into `parts`. */
  readonly display?: PartDisplay;
  /** From the parts to the eye, any length; from the corner when left out. */
  readonly direction?: Vec3;
  readonly projection?: Projection;
  /** Points that must be in the picture, modules; the parts' own corners when left out. */
  readonly frame?: readonly Vec3[];
  /** A backdrop with floor and shadow, or the parts alone on nothing; `clear` when left out. */
  readonly backdrop?: 'studio' | 'clear';
  /** Drawn with the parts and given back undisposed. */
  readonly overlays?: readonly SceneOverlay[];
}

const DISTANCE = 500;
const ORTHOGRAPHIC_MARGIN = 1.1;

/**
 * Draws pictures of parts on a canvas that nobody sees: thumbnails, steps, frames of a film. One
 * graphics context, made when it is first needed; keep one renderer and use it for all pictures.
 */
export class StillRenderer {
  readonly canvas: HTMLCanvasElement;
  readonly #stage: Stage;
  readonly #library: BrickLibrary;
  readonly #materials = new BrickMaterials();
  readonly #model: ModelLayer;

  /** @throws Error when the browser cannot draw in 3D. */
  constructor(catalogue: Catalogue) {
    this.canvas = document.createElement('canvas');
    this.#stage = new Stage(this.canvas, { transparent: true });
    this.#library = new BrickLibrary(catalogue);
    this.#model = new ModelLayer(this.#library, this.#materials);
    this.#stage.scene.add(this.#model.group);
    this.#stage.renderer.setPixelRatio(1);
  }

  /** Draws on `canvas`, where it stays until the next picture: copy it with drawImage(). */
  draw(options: StillOptions): void {
    const { renderer, scene } = this.#stage;
    renderer.setSize(options.width, options.height, false);
    this.#stage.setTheme(viewTheme(options.theme ?? 'light'));
    this.#stage.setBackdrop(options.backdrop ?? 'clear');
    this.#model.setColourScheme(options.colourBy ?? 'part');
    this.#model.setModel({ name: '', parts: options.parts });
    this.#model.setDisplay(options.display ?? null);
    const corners = modelCorners({ name: '', parts: options.parts }, this.#library.catalogue);
    const box = boundsOfPoints(corners);
    this.#stage.frame(box, box?.min[2] ?? 0);
    const points = options.frame ?? corners;
    const { camera, viewHeight } = cameraFor(options, points);
    const pixelsPerModule = options.height / viewHeight;
    const choice = chooseDetail(pixelsPerModule, (detail) => this.#model.trianglesAt(detail));
    this.#model.setDetail(choice.detail);
    this.#model.setLinesVisible(choice.lineOpacity > 0);
    this.#materials.setLineOpacity(choice.lineOpacity);
    const overlays = new OverlayList(() => ({
      theme: this.#stage.theme,
      model: this.#model.model,
      catalogue: this.#library.catalogue,
      pixelsPerModule,
      width: options.width,
      height: options.height,
      invalidate: () => undefined,
    }));
    for (const overlay of options.overlays ?? []) {
      overlays.add(overlay);
    }
    scene.add(overlays.group);
    overlays.update();
    renderer.render(scene, camera);
    scene.remove(overlays.group);
  }

  /** draw() as a PNG. @throws Error when the browser cannot make one. */
  png(options: StillOptions): Promise<Blob> {
    this.draw(options);
    return canvasToPng(this.canvas);
  }

  dispose(): void {
    for (const part of [this.#model, this.#library, this.#materials, this.#stage]) {
      part.dispose();
    }
  }
}

function cameraFor(
  options: StillOptions,
  points: readonly Vec3[],
): { camera: PerspectiveCamera | OrthographicCamera; viewHeight: number } {
  const aspect = options.width / options.height;
  const direction = new Vector3(...(options.direction ?? VIEW_DIRECTIONS.iso)).normalize();
  if (Math.abs(direction.z) > 0.9999) {
    // A little off the pole, so that up stays defined.
    direction.y -= 0.0005;
  }
  if (options.projection === 'orthographic') {
    return orthographic(points, direction, aspect);
  }
  const { target, away } = fitPoints(points, direction, aspect);
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, aspect, 0.1, 4000);
  camera.up.set(0, 0, 1);
  camera.position.copy(target).addScaledVector(direction, away);
  camera.lookAt(target);
  return { camera, viewHeight: 2 * away * Math.tan((FIELD_OF_VIEW * Math.PI) / 360) };
}

function orthographic(
  points: readonly Vec3[],
  direction: Vector3,
  aspect: number,
): { camera: OrthographicCamera; viewHeight: number } {
  const right = new Vector3(0, 0, 1).cross(direction).normalize();
  const up = direction.clone().cross(right).normalize();
  const us = points.map((p) => new Vector3(...p).dot(right));
  const vs = points.map((p) => new Vector3(...p).dot(up));
  const span = (values: readonly number[]) =>
    values.length > 0 ? [Math.min(...values), Math.max(...values)] : [-1, 1];
  const [u0 = -1, u1 = 1] = span(us);
  const [v0 = -1, v1 = 1] = span(vs);
  const height = Math.max(1, v1 - v0, (u1 - u0) / aspect) * ORTHOGRAPHIC_MARGIN;
  const half = height / 2;
  const camera = new OrthographicCamera(-half * aspect, half * aspect, half, -half, 0.1, 4000);
  camera.up.set(0, 0, 1);
  camera.position
    .copy(right.multiplyScalar((u0 + u1) / 2))
    .addScaledVector(up, (v0 + v1) / 2)
    .addScaledVector(direction, DISTANCE);
  camera.lookAt(camera.position.clone().sub(direction));
  return { camera, viewHeight: height };
}
