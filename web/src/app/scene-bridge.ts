import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { Catalogue } from '../model/catalogue.ts';
import type { Model } from '../model/model.ts';
import type { Problem } from '../model/report.ts';
import { emptySketch } from '../model/sketch.ts';
import { jointIndex } from '../state/joint-edits.ts';
import type { PointerInput, ToolView } from '../tools/tool.ts';
import type { PointerTaker } from '../ui/page.ts';
import { findRoom } from '../ui/rooms/room-table.ts';
import { text } from '../ui/text.ts';
import { SceneView } from '../view/scene-view.ts';
import type { LinePreview, Navigation, Pick, SketchMarks, ThemeName } from '../view/view-types.ts';
import { changeLength } from './change-length.ts';
import { JointScene } from './joint-scene.ts';
import type { PageState } from './page-state.ts';
import { PointerFeed, type PointerTarget } from './pointer-feed.ts';
import { SceneAxes } from './scene-axes.ts';
import { SceneDimensions } from './scene-dimensions.ts';
import { SceneLabel } from './scene-label.ts';
import { SceneLocks } from './scene-locks.ts';

const NOTHING: Pick = { line: null, node: null };
/** A press that moves farther than this is a drag. */
const CLICK_PIXELS = 4;
/** Pause after the picture of an unfinished layout, as a multiple of what the picture cost. */
const INTERIM_SHARE = 4;

/** Puts the page's state into the scene and the scene's pointer into the tools. */
export class SceneBridge implements PointerTarget {
  readonly #state: PageState;
  readonly #catalogue: Catalogue;
  readonly webglMissing = signal(false);
  readonly #drawnModel = signal<Model | null>(null);
  /** The model of which the last frame had all parts. */
  readonly drawnModel: ReadonlySignal<Model | null> = this.#drawnModel;
  #view: SceneView | null = null;
  #canvas: HTMLCanvasElement | null = null;
  /** Made with the scene: they need a document. */
  #label: SceneLabel | null = null;
  #locks: SceneLocks | null = null;
  #dimensions: SceneDimensions | null = null;
  #coarse = false;
  #nextInterim = 0;
  #lastModel: Model | null = null;
  #pressedAt: PointerInput | null = null;
  readonly #joint = new JointScene();
  /** Who has taken the press that is under way. */
  #taker: PointerTaker | null = null;

  /** What the tools see of the scene; harmless before there is one. */
  readonly toolView: ToolView = {
    rayAt: (at) =>
      this.#view?.screenToRay(at.x, at.y) ?? { origin: [0, 0, 1], direction: [0, 0, -1] },
    project: (point) => this.#view?.project(point) ?? { x: 0, y: 0, visible: false },
    pickAt: (at) => this.#view?.pick(at.x, at.y, this.#coarse ? 'coarse' : 'fine') ?? NOTHING,
    viewDirection: () => this.#view?.viewDirection() ?? [0, 0, -1],
    pixelsPerModule: () => this.#view?.pixelsPerModule() ?? 1,
  };

  constructor(state: PageState, catalogue: Catalogue) {
    this.#state = state;
    this.#catalogue = catalogue;
  }

  /** Draws into the element until the returned function is called. */
  mount(host: HTMLElement): () => void {
    const canvas = document.createElement('canvas');
    canvas.tabIndex = 0;
    canvas.style.width = '100%';
    canvas.style.height = '100%';
    canvas.setAttribute('role', 'application');
    canvas.setAttribute('aria-label', text.app.drawing);
    canvas.setAttribute('aria-describedby', 'drawing-help');
    const label = new SceneLabel();
    const axes = new SceneAxes();
    const locks = new SceneLocks();
    const dimensions = new SceneDimensions({
      onLength: (wish) => changeLength(this.#state, wish),
      leave: () => this.focus(),
      replace: () => this.#placeLabel(),
    });
    host.append(canvas, axes.element, locks.element, dimensions.element, label.element);
    this.#dimensions = dimensions;
    this.#label = label;
    this.#locks = locks;
    this.#canvas = canvas;
    // Before the view: its controls must find the navigation that fits the press.
    const feed = new PointerFeed(host, canvas, this);
    try {
      this.#view = new SceneView(canvas, {
        catalogue: this.#catalogue,
        onFrame: (model) => {
          this.#placeLabel();
          if (this.#view) {
            axes.place(this.#view, host);
          }
          this.#drawnModel.value = model;
        },
      });
    } catch {
      this.webglMissing.value = true;
    }
    const stop = this.#follow(host);
    return () => {
      stop();
      this.#joint.clear();
      feed.dispose();
      this.#view?.dispose();
      this.#view = null;
      canvas.remove();
      axes.element.remove();
      locks.element.remove();
      dimensions.element.remove();
      label.element.remove();
    };
  }

  focus(): void {
    this.#canvas?.focus({ preventScroll: true });
  }

  /** The scene, or null before it is there or where it cannot be. */
  get view(): SceneView | null {
    return this.#view;
  }

  // --- Pointer -------------------------------------------------------------------------------

  pressed(at: PointerInput): void {
    this.#coarse = at.kind === 'touch';
    this.#taker = this.#state.pointerTaker.value;
    if (this.#taker?.pressed(at)) {
      this.#setNavigation('tool');
      return;
    }
    this.#taker = null;
    this.#pressedAt = at;
    const navigation = this.#state.tool.value.navigation(at);
    this.#setNavigation(navigation);
    this.#view?.setTurntable('off');
    this.#state.tool.value.pointerDown(at);
  }

  moved(at: PointerInput): void {
    this.#coarse = at.kind === 'touch';
    if (this.#taker) {
      this.#taker.moved(at);
      return;
    }
    const tool = this.#state.tool.value;
    tool.pointerMove(at);
    const overPart = tool.id === 'select' && tool.overlay.value.hovered === null;
    this.#state.hoveredPartIndex.value = overPart ? this.#partAt(at) : null;
  }

  released(at: PointerInput): void {
    if (this.#taker) {
      this.#taker.released(at);
      this.#taker = null;
      return;
    }
    this.#state.tool.value.pointerUp(at);
    this.#pickPart(at);
  }

  /** With the selecting tool, a click on a brick and on no line picks the brick. */
  #pickPart(at: PointerInput): void {
    const from = this.#pressedAt;
    this.#pressedAt = null;
    const still = from && Math.hypot(at.x - from.x, at.y - from.y) <= CLICK_PIXELS;
    if (still && this.#state.tool.value.id === 'select') {
      const { line } = this.toolView.pickAt(at);
      this.#state.pickedPart.value = line === null ? this.#partAt(at) : null;
    }
  }

  #partAt(at: PointerInput): number | null {
    return this.#view?.pickPart(at.x, at.y)?.index ?? null;
  }

  left(): void {
    this.#state.hoveredPartIndex.value = null;
    this.#state.tool.value.pointerLeave();
  }

  /** Two fingers or another button: the camera's, so what the first finger began is dropped. */
  abandoned(): void {
    this.#taker?.released(null);
    this.#taker = null;
    this.#state.tool.value.pointerLeave();
  }

  #setNavigation(navigation: Navigation): void {
    this.#view?.setNavigation(navigation);
  }

  // --- State to scene ------------------------------------------------------------------------

  #follow(host: HTMLElement): () => void {
    const state = this.#state;
    // The overlay changes with every move of the pointer, what it hovers over seldom: a sketch must not
    // be drawn anew because a line's end has moved.
    const hovered = computed(() => state.tool.value.overlay.value.hovered);
    const handle = computed(() => state.tool.value.overlay.value.handle);
    const stops = [
      effect(() => this.#view?.setTheme(state.themeName.value as ThemeName)),
      effect(() => this.#showSketch(hovered.value)),
      effect(() => this.#showModel()),
      effect(() => this.#view?.setMode(state.preferences.value.show)),
      effect(() => this.#view?.colourBy(state.preferences.value.colourBy)),
      effect(() => this.#view?.setProjection(state.preferences.value.projection)),
      effect(() => this.#view?.explode(state.explode.value)),
      effect(() => this.#view?.isolate(state.isolation.value)),
      effect(() => this.#view?.setSection(state.section.value)),
      effect(() => this.#view?.display(state.display.value)),
      effect(() => this.#view?.markParts(state.partMarks.value)),
      effect(() => this.#view?.setCovered(findRoom(state.room.value) !== null)),
      effect(() => this.#showOverlay(host)),
      effect(() => this.#joint.show(this.#view, state, handle.value)),
      effect(() => this.#showLocks()),
      effect(() => this.#showDimensions()),
    ];
    return () => {
      for (const stop of stops) {
        stop();
      }
    };
  }

  #showSketch(hovered: number | null): void {
    const { store, problemPoints, problemLines, proposedSymmetry, tool, joint } = this.#state;
    const marks: SketchMarks = {
      selected: store.selection.value,
      hovered,
      errors: problemLines.value,
      errorPoints: problemPoints.value,
      proposedSymmetry: proposedSymmetry.value,
      selectedJoint: tool.value.id === 'joint' ? jointIndex(store.sketch.value, joint.value) : null,
    };
    this.#view?.setSketch(store.sketch.value, marks);
  }

  #showModel(): void {
    const shown = this.#state.shown.value;
    const dimmed = this.#state.unfit.value;
    if (shown?.model !== this.#lastModel) {
      this.#lastModel = shown?.model ?? null;
      this.#state.forgetParts();
    }
    const interim = shown !== null && shown.report === null;
    const now = performance.now();
    // A slow machine must not spend its time on pictures of layouts that are about to be improved.
    if (interim && now < this.#nextInterim) {
      return;
    }
    this.#view?.setModel(shown?.model ?? null, { dimmed });
    if (interim) {
      this.#nextInterim = Number.POSITIVE_INFINITY;
      requestAnimationFrame(() =>
        requestAnimationFrame(() => {
          const cost = performance.now() - now;
          this.#nextInterim = performance.now() + INTERIM_SHARE * cost;
        }),
      );
    }
  }

  #showOverlay(host: HTMLElement): void {
    const tool = this.#state.tool.value;
    const overlay = tool.overlay.value;
    const drawing = tool.id !== 'select' && tool.id !== 'split' && tool.id !== 'joint';
    const pickable = overlay.hovered !== null || overlay.handle !== null;
    host.dataset['cursor'] = drawing ? 'draw' : pickable ? 'pick' : '';
    // Tools that draw show where: the plane appears with the pointer or the keyboard's cursor.
    const plane = overlay.cursor || overlay.preview ? overlay.plane : null;
    this.#view?.setGuidePlane(plane, overlay.cursor);
    this.#view?.setPreview(overlay.preview ?? previewOf(this.#state.ghostLines.value));
    this.#label?.set(overlay.label);
    this.#placeLabel();
  }

  /** Padlocks lie on a model that is as the sketch wants it. */
  #showLocks(): void {
    const { store, shown, preferences } = this.#state;
    const bare = shown.value === null || preferences.value.show === 'sketch';
    this.#locks?.set(bare ? emptySketch() : store.sketch.value);
    this.#placeLabel();
  }

  /** Lengths of selected lines, or of all; that of a single one can be changed. */
  #showDimensions(): void {
    const { store, tool, preferences } = this.#state;
    const [sketch, selection] = [store.sketch.value, store.selection.value];
    const { show, dimensions } = preferences.value;
    const selecting = tool.value.id === 'select';
    const [first] = selection;
    const all = dimensions ? sketch.lines.keys() : [];
    const shown = show === 'model' ? [] : new Set([...(selecting ? selection : []), ...all]);
    const edited = selecting && selection.size === 1 ? (first ?? null) : null;
    this.#dimensions?.set(sketch, shown, edited);
    this.#placeLabel();
  }

  /** @returns whether a key was the beginning of a length. */
  typed(key: string): boolean {
    return this.#dimensions?.type(key) ?? false;
  }

  #placeLabel(): void {
    const view = this.#view;
    if (view) {
      this.#label?.place((at) => view.project(at));
      this.#locks?.place((at) => view.project(at));
      this.#dimensions?.place((at) => view.project(at));
    }
  }

  /** Brings the place of a problem to the middle of the picture. */
  showPlace(problem: Problem): void {
    const part = problem.parts?.[0];
    const at = problem.at ?? (part === undefined ? null : this.#view?.partCentre(part));
    if (at) {
      this.#view?.centreOn(at);
    }
  }
}

function previewOf([first, ...more]: PageState['ghostLines']['value']): LinePreview | null {
  return first ? { from: first[0], to: first[1], state: 'ok', more } : null;
}
