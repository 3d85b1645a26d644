import { Plane, Vector2, Vector3 } from 'three';
import { type Bounds, corners, sketchBounds, unionBounds } from '../model/bounds.ts';
import type { Model } from '../model/model.ts';
import type { SketchDocument } from '../model/sketch.ts';
import { unitVector, type Vec3 } from '../model/vec.ts';
import { BrickLibrary } from './bricks/brick-library.ts';
import { BrickMaterials } from './bricks/brick-materials.ts';
import { chooseDetail } from './level-of-detail.ts';
import { ModelLayer, type PartMarks } from './model-layer.ts';
import { CameraRig } from './scene/camera-rig.ts';
import { ScreenSpace } from './scene/screen-space.ts';
import { Stage } from './scene/stage.ts';
import { viewTheme } from './scene/theme.ts';
import { GuidePlaneLayer } from './sketch/guide-plane-layer.ts';
import { PreviewLayer } from './sketch/preview-layer.ts';
import { SketchLayer } from './sketch/sketch-layer.ts';
import { pickLine, pickNode } from './sketch-picking.ts';
import type {
  ColourScheme,
  GuidePlane,
  Isolation,
  LinePreview,
  ModelOptions,
  Navigation,
  Pick,
  Projected,
  Projection,
  Ray,
  SceneViewOptions,
  Section,
  SketchMarks,
  StandardView,
  ThemeName,
  ViewMode,
  ViewStats,
} from './view-types.ts';

/** How near the pointer must be, CSS pixels. */
const REACH = { line: 8, node: 12, coarse: 2 } as const;
/** How pale a model becomes that does not fit the sketch any more. */
const DIM_AMOUNT = 0.62;

/**
 * The 3D view of sketch and model on one canvas. It draws only when something has changed; whoever
 * changes nothing costs nothing. Positions in space are modules, on screen CSS pixels.
 */
export class SceneView {
  readonly #canvas: HTMLCanvasElement;
  readonly #options: SceneViewOptions;
  readonly #stage: Stage;
  readonly #rig: CameraRig;
  readonly #materials = new BrickMaterials();
  readonly #library: BrickLibrary;
  readonly #model: ModelLayer;
  readonly #sketch = new SketchLayer();
  readonly #guide = new GuidePlaneLayer();
  readonly #preview = new PreviewLayer();
  readonly #resize: ResizeObserver;
  readonly #screen: ScreenSpace;
  #marks: SketchMarks = {};
  #previewLine: LinePreview | null = null;
  #mode: ViewMode = 'both';
  #dimmed = false;
  #frame = 0;
  #contextLost = false;

  constructor(canvas: HTMLCanvasElement, options: SceneViewOptions) {
    this.#canvas = canvas;
    this.#options = options;
    this.#stage = new Stage(canvas);
    this.#library = new BrickLibrary(options.catalogue);
    this.#model = new ModelLayer(this.#library, this.#materials);
    const layers = [this.#model, this.#sketch, this.#guide, this.#preview];
    this.#stage.scene.add(...layers.map((layer) => layer.group));
    this.#rig = new CameraRig(canvas, {
      reducedMotion: options.reducedMotion ?? prefersReducedMotion(),
      onChange: () => this.invalidate(),
    });
    this.#screen = new ScreenSpace(canvas, () => this.#rig.camera);
    this.#resize = new ResizeObserver(() => this.#fitCanvas());
    this.#resize.observe(canvas);
    canvas.addEventListener('webglcontextlost', this.#onContextLost);
    canvas.addEventListener('webglcontextrestored', this.#onContextRestored);
    this.setTheme(options.theme ?? 'light');
    this.#fitCanvas();
    this.#applyMode();
    this.#reframe();
  }

  // --- What is shown -------------------------------------------------------------------------

  /** Shows a model; null takes it away. */
  setModel(model: Model | null, options: ModelOptions = {}): void {
    if (model !== this.#model.model) {
      this.#model.setModel(model);
      this.#reframe();
    }
    this.#dimmed = options.dimmed ?? false;
    this.#applyFade();
    this.invalidate();
  }

  /** Shows a sketch with what stands out in it; null takes it away. */
  setSketch(sketch: SketchDocument | null, marks: SketchMarks = {}): void {
    const changed = sketch !== this.#sketch.sketch;
    this.#marks = marks;
    this.#sketch.set(sketch, marks, this.#stage.theme);
    if (changed) {
      this.#reframe();
    }
    this.invalidate();
  }

  /** Shows the plane that is drawn on, with the unit grid round the cursor. */
  setGuidePlane(plane: GuidePlane | null, cursor: Vec3 | null = null): void {
    this.#guide.set(plane, cursor);
    this.invalidate();
  }

  /** Shows the line being drawn. Place its length label with project(). */
  setPreview(preview: LinePreview | null): void {
    this.#previewLine = preview;
    this.#preview.set(preview, this.#stage.theme);
    this.invalidate();
  }

  setMode(mode: ViewMode): void {
    this.#mode = mode;
    this.#applyMode();
    this.invalidate();
  }

  setTheme(name: ThemeName): void {
    const theme = viewTheme(name);
    this.#stage.setTheme(theme);
    this.#guide.setTheme(theme);
    this.#sketch.set(this.#sketch.sketch, this.#marks, theme);
    this.#preview.set(this.#previewLine, theme);
    this.#applyFade();
    this.invalidate();
  }

  /** Moves parts apart. @param amount 0 (as built) to 1. */
  explode(amount: number): void {
    this.#model.setExplode(amount);
    this.#reframe();
    this.invalidate();
  }

  colourBy(scheme: ColourScheme): void {
    this.#model.setColourScheme(scheme);
    this.invalidate();
  }

  /** Shows some parts alone; null shows all. */
  isolate(isolation: Isolation | null): void {
    this.#model.setIsolation(isolation);
    this.#stage.shadowChanged();
    this.invalidate();
  }

  /** Parts that stand out, by index. */
  markParts(marks: PartMarks): void {
    this.#model.setMarks(marks);
    this.invalidate();
  }

  /** Cuts the model open; null closes it. */
  setSection(section: Section | null): void {
    const normal = section ? new Vector3(...unitVector(section.axis)).negate() : null;
    this.#materials.setSection(normal ? new Plane(normal, section?.offset ?? 0) : null);
    this.#stage.shadowChanged();
    this.invalidate();
  }

  // --- Camera --------------------------------------------------------------------------------

  /** Brings everything shown into the picture; with a view, from that side. */
  fit(view?: StandardView): void {
    const points = this.#shownPoints();
    this.#rig.fit(points.length > 0 ? points : corners(DEFAULT_BOX), view);
  }

  /** Looks from a standard side at what is looked at now. */
  setView(view: StandardView): void {
    this.#rig.look(view);
  }

  /** Brings a place to the middle of the picture without turning. */
  centreOn(point: Vec3): void {
    this.#rig.centreOn(point);
  }

  /** Turns about what is looked at: radians to the right and upwards. */
  turn(azimuth: number, elevation: number): void {
    this.#rig.turn(azimuth, elevation);
  }

  /** Goes nearer (factor below 1) or farther. */
  zoom(factor: number): void {
    this.#rig.zoom(factor);
  }

  setProjection(projection: Projection): void {
    this.#rig.setProjection(projection);
    this.invalidate();
  }

  get projection(): Projection {
    return this.#rig.projection;
  }

  setNavigation(navigation: Navigation): void {
    this.#rig.setNavigation(navigation);
  }

  /** Turns the model slowly by itself; not when reduced motion is asked for. */
  setTurntable(state: 'on' | 'off'): void {
    this.#rig.setTurntable(state);
  }

  /** Unit vector from the eye into the picture: tells which guiding plane faces the viewer. */
  viewDirection(): Vec3 {
    const direction = this.#rig.camera.getWorldDirection(new Vector3());
    return [direction.x, direction.y, direction.z];
  }

  // --- Between screen and space --------------------------------------------------------------

  /** The ray through a place on screen. */
  screenToRay(x: number, y: number): Ray {
    return this.#screen.toRay(x, y);
  }

  /** Where a point of space is on screen. */
  project(point: Vec3): Projected {
    return this.#screen.project(point);
  }

  /** What lies under a place on screen. @param pointer `coarse` for a finger: reaches further. */
  pick(x: number, y: number, pointer: 'fine' | 'coarse' = 'fine'): Pick {
    const reach = pointer === 'coarse' ? REACH.coarse : 1;
    const at = { x, y };
    const project = this.#screen.projector();
    const showsSketch = this.#mode !== 'model';
    const lines = showsSketch ? (this.#sketch.sketch?.lines ?? []) : [];
    const nodes = showsSketch ? this.#sketch.nodes : [];
    return {
      line: pickLine(at, lines, project, REACH.line * reach),
      node: pickNode(at, nodes, project, REACH.node * reach),
      part: this.#mode === 'sketch' ? null : this.#model.pick(this.screenToRay(x, y)),
    };
  }

  /** Middle of a part as drawn (exploded or not), or null. */
  partCentre(index: number): Vec3 | null {
    return this.#model.partCentre(index);
  }

  // --- Frames --------------------------------------------------------------------------------

  /** Asks for one more frame; many calls before it make one. */
  invalidate(): void {
    if (this.#frame === 0 && !this.#contextLost) {
      this.#frame = requestAnimationFrame(this.#onFrame);
    }
  }

  /** Cost of the last frame. */
  stats(): ViewStats {
    const { calls, triangles, lines } = this.#stage.renderer.info.render;
    return { drawCalls: calls, triangles, lines };
  }

  /** The present view as a picture. @throws Error when the browser cannot make one. */
  renderToPng(width: number, height: number): Promise<Blob> {
    const { renderer } = this.#stage;
    const before = { ...this.#screen.size(), ratio: renderer.getPixelRatio() };
    renderer.setPixelRatio(1);
    this.#applySize(width, height);
    this.#draw();
    // The bitmap is taken at the call, so the canvas may have its own size back at once.
    const picture = new Promise<Blob>((resolve, reject) => {
      this.#canvas.toBlob((blob) => {
        if (blob) {
          resolve(blob);
        } else {
          reject(new Error('The browser could not make a picture of the view.'));
        }
      }, 'image/png');
    });
    renderer.setPixelRatio(before.ratio);
    this.#applySize(before.width, before.height);
    this.#draw();
    return picture;
  }

  dispose(): void {
    cancelAnimationFrame(this.#frame);
    this.#resize.disconnect();
    this.#canvas.removeEventListener('webglcontextlost', this.#onContextLost);
    this.#canvas.removeEventListener('webglcontextrestored', this.#onContextRestored);
    const parts = [this.#rig, this.#model, this.#sketch, this.#guide, this.#preview];
    for (const part of [...parts, this.#library, this.#materials, this.#stage]) {
      part.dispose();
    }
  }

  readonly #onFrame = (now: number): void => {
    this.#frame = 0;
    const more = this.#rig.update(now);
    this.#draw();
    this.#options.onFrame?.();
    if (more) {
      this.invalidate();
    }
  };

  #draw(): void {
    const { height } = this.#stage.renderer.getSize(new Vector2());
    const pixelsPerModule = height / this.#rig.viewHeight();
    const choice = chooseDetail(pixelsPerModule, (detail) => this.#model.trianglesAt(detail));
    if (this.#model.setDetail(choice.detail)) {
      this.#stage.shadowChanged();
    }
    this.#model.setLinesVisible(choice.lineOpacity > 0);
    this.#materials.setLineOpacity(choice.lineOpacity);
    this.#stage.renderer.render(this.#stage.scene, this.#rig.camera);
  }

  #fitCanvas(): void {
    const limit = this.#options.pixelRatioLimit ?? 2;
    this.#stage.renderer.setPixelRatio(Math.min(globalThis.devicePixelRatio || 1, limit));
    const { width, height } = this.#screen.size();
    this.#applySize(width, height);
    this.invalidate();
  }

  #applySize(width: number, height: number): void {
    const { renderer } = this.#stage;
    renderer.setSize(width, height, false);
    this.#rig.setAspect(width / height);
    this.#sketch.setResolution(width, height, renderer.getPixelRatio());
    this.#preview.setResolution(width, height, renderer.getPixelRatio());
  }

  #applyMode(): void {
    this.#model.group.visible = this.#mode !== 'sketch';
    this.#sketch.group.visible = this.#mode !== 'model';
    this.#sketch.setOverlay(this.#mode === 'both' ? 'over' : 'within');
    this.#stage.ground.setShadowVisible(this.#mode !== 'sketch');
  }

  #applyFade(): void {
    const towards = this.#stage.theme.backgroundBottom;
    this.#model.setFade(this.#dimmed ? { towards, amount: DIM_AMOUNT } : null);
  }

  /** Floor and light follow what there is to see. */
  #reframe(): void {
    const sketch = this.#sketch.sketch;
    const box = unionBounds(this.#model.bounds, sketch ? sketchBounds(sketch) : null);
    const floor = Math.min(sketch?.ground ?? Infinity, box?.min[2] ?? Infinity);
    this.#stage.frame(box, Number.isFinite(floor) ? floor : 0);
  }

  #shownPoints(): Vec3[] {
    const lines = this.#mode === 'model' ? [] : (this.#sketch.sketch?.lines ?? []);
    const parts = this.#mode === 'sketch' ? [] : this.#model.corners();
    return [...lines.flatMap((line) => [line.from, line.to]), ...parts];
  }

  readonly #onContextLost = (event: Event): void => {
    // Tells the browser that we go on when it gives the context back.
    event.preventDefault();
    this.#contextLost = true;
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#options.onContext?.('lost');
  };

  readonly #onContextRestored = (): void => {
    this.#contextLost = false;
    this.#stage.restore();
    this.invalidate();
    this.#options.onContext?.('restored');
  };
}

/** What an empty view shows: a sketching area of ten by ten modules. */
const DEFAULT_BOX: Bounds = { min: [-6, -6, -1], max: [6, 6, 5] };

function prefersReducedMotion(): boolean {
  return globalThis.matchMedia?.('(prefers-reduced-motion: reduce)').matches ?? false;
}
