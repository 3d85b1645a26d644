import { Plane, Vector2, Vector3 } from 'three';
import { unitVector, type Vec3 } from '../geometry/vec.ts';
import { corners, sketchBounds, sketchPoints, unionBounds } from '../model/bounds.ts';
import type { Model } from '../model/model.ts';
import type { SketchDocument } from '../model/sketch.ts';
import { BrickLibrary } from './bricks/brick-library.ts';
import { BrickMaterials } from './bricks/brick-materials.ts';
import { ModelLayer, type PartMarks } from './model-layer.ts';
import type { OverlayContext, SceneOverlay } from './overlays/overlay.ts';
import { OverlayList } from './overlays/overlay-list.ts';
import { CameraRig } from './scene/camera-rig.ts';
import { watchContext } from './scene/context-watch.ts';
import { DEFAULT_BOX, prefersReducedMotion } from './scene/defaults.ts';
import { ScreenSpace } from './scene/screen-space.ts';
import { Stage } from './scene/stage.ts';
import { viewTheme } from './scene/theme.ts';
import { SKETCH_OVERLAY, SketchScene } from './sketch/sketch-scene.ts';
import { pickSketch } from './sketch-picking.ts';
import { canvasToPng } from './still/canvas-png.ts';
import type {
  ColourScheme,
  GuidePlane,
  Isolation,
  LinePreview,
  ModelOptions,
  Navigation,
  PartDisplay,
  PartPick,
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
} from './view-types.ts';

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
  readonly #sketch: SketchScene;
  readonly #overlays = new OverlayList(() => this.#overlayContext());
  readonly #resize: ResizeObserver;
  readonly #screen: ScreenSpace;
  readonly #unwatch: () => void;
  #mode: ViewMode = 'both';
  #dimmed: boolean | ReadonlySet<number> = false;
  #frame = 0;
  #contextLost = false;
  #covered = false;

  constructor(canvas: HTMLCanvasElement, options: SceneViewOptions) {
    this.#canvas = canvas;
    this.#options = options;
    this.#stage = new Stage(canvas);
    this.#library = new BrickLibrary(options.catalogue);
    this.#model = new ModelLayer(this.#library, this.#materials, 'in-slices');
    this.#sketch = new SketchScene(this.#stage.theme);
    this.#stage.scene.add(this.#model.group, ...this.#sketch.objects, this.#overlays.group);
    this.#rig = new CameraRig(canvas, {
      reducedMotion: options.reducedMotion ?? prefersReducedMotion(),
      onChange: () => this.invalidate(),
    });
    this.#screen = new ScreenSpace(canvas, () => this.#rig.camera);
    this.#resize = new ResizeObserver(() => this.#fitCanvas());
    this.#resize.observe(canvas);
    this.#unwatch = watchContext(canvas, this.#onContext);
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
      this.#overlays.refresh();
    }
    this.#dimmed = options.dimmed ?? false;
    this.#applyFade();
    this.invalidate();
  }

  /** Shows a sketch with what stands out in it; null takes it away. */
  setSketch(sketch: SketchDocument | null, marks: SketchMarks = {}): void {
    if (this.#sketch.set(sketch, marks)) {
      this.#reframe();
    }
    this.invalidate();
  }

  /** Shows the plane that is drawn on, with the unit grid round the cursor. */
  setGuidePlane(plane: GuidePlane | null, cursor: Vec3 | null = null): void {
    this.#sketch.setGuidePlane(plane, cursor);
    this.invalidate();
  }

  /** Shows the line being drawn. Place its length label with project(). */
  setPreview(preview: LinePreview | null): void {
    this.#sketch.setPreview(preview);
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
    this.#sketch.setTheme(theme);
    this.#applyFade();
    this.#overlays.refresh();
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

  /** Draws parts otherwise than the model has them (PartDisplay); null ends that. */
  display(display: PartDisplay | null): void {
    this.#model.setDisplay(display);
    this.#stage.shadowChanged();
    this.invalidate();
  }

  /** Draws something of somebody else's. @returns what takes it away again. */
  addOverlay(overlay: SceneOverlay): () => void {
    const remove = this.#overlays.add(overlay);
    this.invalidate();
    return remove;
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

  /** Brings a place to the middle of the picture, or by a share of its height above it, without turning. */
  centreOn(point: Vec3, above = 0): void {
    this.#rig.centreOn(point, above);
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

  /** CSS pixels that one module takes at what is looked at. */
  pixelsPerModule(): number {
    return this.#screen.size().height / this.#rig.viewHeight();
  }

  /** What of the sketch lies there on screen. @param pointer `coarse` for a finger: reaches further. */
  pick(x: number, y: number, pointer: 'fine' | 'coarse' = 'fine'): Pick {
    return this.#mode === 'model'
      ? { line: null, node: null }
      : pickSketch({ x, y }, this.#sketch, this.#screen.projector(), pointer);
  }

  /** The brick under a place on screen, or null. */
  pickPart(x: number, y: number): PartPick | null {
    return this.#mode === 'sketch' ? null : this.#model.pick(this.screenToRay(x, y));
  }

  /** Middle of a part as drawn (exploded or not), or null. */
  partCentre(index: number): Vec3 | null {
    return this.#model.partCentre(index);
  }

  // --- Frames --------------------------------------------------------------------------------

  /** Asks for one more frame; many calls before it make one. */
  invalidate(): void {
    if (this.#frame === 0 && !this.#contextLost && !this.#covered) {
      this.#frame = requestAnimationFrame(this.#onFrame);
    }
  }

  /** While it is covered nothing is drawn; what changes meanwhile is seen afterwards. */
  setCovered(covered: boolean): void {
    this.#covered = covered;
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.invalidate();
  }

  /** The present view as a picture. @throws Error when the browser cannot make one. */
  renderToPng(width: number, height: number): Promise<Blob> {
    const { renderer } = this.#stage;
    const before = { ...this.#screen.size(), ratio: renderer.getPixelRatio() };
    renderer.setPixelRatio(1);
    this.#applySize({ width, height });
    this.#chooseDetail();
    this.#model.advance(Infinity);
    this.#draw();
    // The bitmap is taken at the call, so the canvas may have its own size back at once.
    const picture = canvasToPng(this.#canvas);
    renderer.setPixelRatio(before.ratio);
    this.#applySize(before);
    this.#draw();
    return picture;
  }

  dispose(): void {
    cancelAnimationFrame(this.#frame);
    this.#resize.disconnect();
    this.#unwatch();
    const parts = [this.#overlays, this.#rig, this.#model, this.#sketch];
    for (const part of [...parts, this.#library, this.#materials, this.#stage]) {
      part.dispose();
    }
  }

  readonly #onFrame = (now: number): void => {
    this.#frame = 0;
    const more = this.#rig.update(now);
    this.#chooseDetail();
    this.#changedIf(this.#model.buildBeforeFrame());
    this.#draw();
    this.#options.onFrame?.(this.#model.wholeModel);
    this.#changedIf(this.#model.buildAfterFrame());
    if (more) {
      this.invalidate();
    }
  };

  #changedIf(built: boolean): void {
    if (built) {
      this.#stage.shadowChanged();
      this.invalidate();
    }
  }

  #draw(): void {
    this.#chooseDetail();
    this.#overlays.update();
    this.#stage.renderer.render(this.#stage.scene, this.#rig.camera);
  }

  #chooseDetail(): void {
    const { height } = this.#stage.renderer.getSize(new Vector2());
    if (this.#model.suit(height / this.#rig.viewHeight())) {
      this.#stage.shadowChanged();
    }
  }

  #overlayContext(): OverlayContext {
    const { width, height } = this.#screen.size();
    return {
      theme: this.#stage.theme,
      model: this.#model.model,
      catalogue: this.#library.catalogue,
      pixelsPerModule: this.pixelsPerModule(),
      width,
      height,
      invalidate: () => this.invalidate(),
    };
  }

  #fitCanvas(): void {
    const limit = this.#options.pixelRatioLimit ?? 2;
    this.#stage.renderer.setPixelRatio(Math.min(globalThis.devicePixelRatio || 1, limit));
    this.#applySize(this.#screen.size());
    this.invalidate();
  }

  #applySize({ width, height }: { readonly width: number; readonly height: number }): void {
    const { renderer } = this.#stage;
    renderer.setSize(width, height, false);
    this.#rig.setAspect(width / height);
    this.#sketch.setResolution(width, height, renderer.getPixelRatio());
    this.#overlays.refresh();
  }

  #applyMode(): void {
    this.#model.group.visible = this.#mode !== 'sketch';
    this.#sketch.setOverlay(SKETCH_OVERLAY[this.#mode]);
    this.#stage.ground.setShadowVisible(this.#mode !== 'sketch');
  }

  #applyFade(): void {
    const towards = this.#stage.theme.backgroundBottom;
    const only = this.#dimmed;
    this.#model.setFade(only === false ? null : { towards, only });
  }

  /** Floor and light follow what there is to see. */
  #reframe(): void {
    const sketch = this.#sketch.sketch;
    const box = unionBounds(this.#model.bounds, sketch ? sketchBounds(sketch) : null);
    const floor = Math.min(sketch?.ground ?? Infinity, box?.min[2] ?? Infinity);
    this.#stage.frame(box, Number.isFinite(floor) ? floor : 0);
  }

  #shownPoints(): Vec3[] {
    const drawn = this.#mode === 'model' ? [] : sketchPoints(this.#sketch.sketch);
    const parts = this.#mode === 'sketch' ? [] : this.#model.corners();
    return [...drawn, ...parts];
  }

  readonly #onContext = (state: 'lost' | 'restored'): void => {
    this.#contextLost = state === 'lost';
    if (state === 'lost') {
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
    } else {
      this.#stage.restore();
      this.invalidate();
    }
    this.#options.onContext?.(state);
  };
}
