import { computed, effect, type Signal, signal } from '@preact/signals';
import type { AxisName, Vec3 } from '../geometry/vec.ts';
import { middleAlong, modelBounds } from '../model/bounds.ts';
import type { Catalogue } from '../model/catalogue.ts';
import {
  emptySketch,
  type SketchDocument,
  type SketchLine,
  type SketchSymmetry,
} from '../model/sketch.ts';
import type { MadeParts } from '../solver/made-file.ts';
import type { SolverClient } from '../solver/worker-client.ts';
import { addSymmetry, removeSymmetry } from '../state/edits.ts';
import type { JointPlace } from '../state/joint-edits.ts';
import { pagePreferences } from '../state/page-preferences.ts';
import type { Preferences } from '../state/preferences.ts';
import { SEARCH_KEYS, type SearchSettings } from '../state/search-settings.ts';
import { mendFault, type SketchFault } from '../state/sketch-faults.ts';
import type { KeptState } from '../state/sketch-records.ts';
import type { SavedSketch, SketchStore } from '../state/store.ts';
import { nextPlaneMode } from '../tools/guide.ts';
import type { PlaneMode, Tool, ToolId } from '../tools/tool.ts';
import { createTools } from '../tools/tool-set.ts';
import type { Example, LayoutSnapshot, PartKind } from '../ui/page.ts';
import { isLookedAtPlace, nameOfPlace, placeOf } from '../ui/places.ts';
import { settingsOf } from '../ui/solve-settings.ts';
import { inWords } from '../ui/text/sentences.ts';
import { text } from '../ui/text.ts';
import type { StandardView } from '../view/view-types.ts';
import type { Actions, CameraMove } from './actions.ts';
import { namedSketch } from './example-list.ts';
import { FIRST_MODEL } from './first-model.ts';
import { PageFiles } from './page-files.ts';
import { PageState } from './page-state.ts';
import { SceneBridge } from './scene-bridge.ts';
import { SketchShelf } from './sketch-shelf.ts';
import { SolveRun } from './solve-run.ts';
import { Toaster } from './toasts.ts';

interface ControllerOptions {
  readonly store: SketchStore;
  /** The person's own. */
  readonly preferences: Signal<Preferences>;
  readonly catalogue: Catalogue;
  readonly client: SolverClient;
}

const TURN_BACK_MS = 50;

function isSpecial(ofSketch: SearchSettings | null, own: SearchSettings): boolean {
  return ofSketch !== null && !SEARCH_KEYS.every((key) => same(ofSketch[key], own[key]));
}

function same(a: unknown, b: unknown): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

/** Does what the commands ask for. It owns the parts of the page; each part knows only itself. */
export class PageController implements Actions {
  readonly state: PageState;
  readonly scene: SceneBridge;
  readonly toaster = new Toaster();
  readonly run: SolveRun;
  readonly shelf: SketchShelf;
  readonly files: PageFiles;
  readonly #tools: ReadonlyMap<ToolId, Tool>;
  clipboard: readonly SketchLine[] = [];
  /** What the sketch on the page brought to be searched with; null for the person's own. */
  readonly #ofSketch: Signal<SearchSettings | null>;
  /** The sketch that came as a whole last, by a file, a link, an example or the last visit. */
  #opened: SketchDocument | null = null;

  constructor(options: ControllerOptions) {
    const { store, preferences, catalogue, client } = options;
    this.#ofSketch = signal<SearchSettings | null>(null);
    this.shelf = new SketchShelf({
      store,
      settings: this.#ofSketch,
      onFollowed: (kept) => this.#follow(kept),
      onEvent: (event) => this.toaster.error(text.tabs[event]),
    });
    this.run = new SolveRun(client);
    const planeMode = signal<PlaneMode>('auto');
    const joint = signal<JointPlace | null>(null);
    let scene: SceneBridge | null = null;
    this.#tools = createTools({
      store,
      view: {
        rayAt: (at) => this.scene.toolView.rayAt(at),
        project: (point) => this.scene.toolView.project(point),
        pickAt: (at) => this.scene.toolView.pickAt(at),
        // Tools ask for it while they are made, before there is a scene.
        viewDirection: () => scene?.toolView.viewDirection() ?? [0, 0, -1],
        pixelsPerModule: () => this.scene.toolView.pixelsPerModule(),
      },
      joint,
      plane: planeMode,
      nextPlane: () => {
        planeMode.value = nextPlaneMode(planeMode.value);
      },
      announce: (message) => this.announce(message),
      words: text,
    });
    this.state = new PageState({
      store,
      preferences: pagePreferences(preferences, this.#ofSketch),
      ownSettings: computed(() => isSpecial(this.#ofSketch.value, preferences.value)),
      catalogue,
      solve: this.run.state,
      shown: this.run.shown,
      tool: signal(this.#toolOf('select')),
      planeMode,
      joint,
    });
    scene = new SceneBridge(this.state, catalogue);
    this.scene = scene;
    this.files = new PageFiles({
      state: this.state,
      scene,
      toaster: this.toaster,
      run: this.run,
      client,
      replaceSketch: (sketch) => this.replaceSketch(sketch),
      edit: this.edit,
      useTool: this.useTool,
      fit: this.fit,
    });
  }

  // --- Tools and edits -----------------------------------------------------------------------

  readonly useTool = (id: ToolId): void => {
    const { tool, room } = this.state;
    if (id !== 'select' && isLookedAtPlace(room.value)) {
      // Tools are for drawing: whoever takes one goes there.
      room.value = null;
    }
    tool.value.reset();
    tool.value = this.#toolOf(id);
    tool.value.reset();
    this.announce(text.toolNames[id]);
  };

  /** Escape with nothing left to step back from. */
  readonly rest = (): void => {
    if (this.state.pickedPart.value !== null) {
      this.state.pickedPart.value = null;
    } else {
      this.useTool('select');
    }
  };

  readonly focusDrawing = (): void => this.scene.focus();

  readonly edit = (label: string, next: SketchDocument): void => {
    this.state.store.commit(label, next);
    this.announce(label);
  };

  readonly undo = (): void => {
    this.state.tool.value.reset();
    const label = this.state.store.undo();
    this.announce(`${text.commands.undo}: ${label ?? ''}`);
  };

  readonly redo = (): void => {
    this.state.tool.value.reset();
    const label = this.state.store.redo();
    this.announce(`${text.commands.redo}: ${label ?? ''}`);
  };

  readonly openRoom = (id: string | null): void => {
    const { tool, room } = this.state;
    tool.value.reset();
    room.value = nameOfPlace(placeOf(id));
    if (isLookedAtPlace(room.value)) {
      this.useTool('select');
    }
  };

  readonly announce = (message: string): void => {
    const { announcement } = this.state;
    // The same words again are said again only when the text changes.
    announcement.value = announcement.value === message ? `${message}\u00a0` : message;
  };

  readonly rename = (name: string): void => {
    const sketch = this.state.store.sketch.value;
    if ((sketch.name ?? '') !== name.trim()) {
      this.edit(text.edits.rename, { ...sketch, name: name.trim() });
    }
  };

  readonly mend = (fault: SketchFault): void => {
    this.edit(text.faults.edit, mendFault(this.state.store.sketch.value, fault));
  };

  readonly confirmSymmetry = (symmetry: SketchSymmetry): void => {
    this.state.proposedSymmetry.value = null;
    this.edit(text.symmetry.edit, addSymmetry(this.state.store.sketch.value, symmetry));
  };

  readonly dropSymmetry = (index: number): void => {
    this.edit(text.symmetry.edit, removeSymmetry(this.state.store.sketch.value, index));
  };

  readonly showPlace = (at: Vec3): void => this.scene.view?.centreOn(at);

  // --- Files ---------------------------------------------------------------------------------

  readonly newSketch = (): void => {
    this.state.dialog.value = null;
    this.shelf.leave(emptySketch());
    this.state.came.value = null;
    this.run.clear();
    this.edit(text.edits.clear, emptySketch());
    this.useTool('line');
    this.scene.focus();
    this.fit();
  };

  /** Puts a kept sketch on the page, with its own history. */
  readonly openKept = (id: string): void => {
    this.shelf.open(id).then(
      (saved) => {
        if (saved) {
          this.state.tool.value.reset();
          this.run.clear();
          this.begin(saved);
          this.useTool('select');
        }
      },
      () => this.toaster.error(text.files.unreadable),
    );
  };

  /** The sketch that the page begins with; there is nothing to go back to. */
  begin(saved: SavedSketch): void {
    this.#opened = saved.sketch;
    this.state.store.restore(saved);
    this.fit();
  }

  /** Another tab has drawn on: its sketch takes the page, with its history. */
  #follow(saved: KeptState): void {
    this.state.came.value = null;
    this.state.store.restore(saved);
    this.toaster.info(text.tabs.changed);
  }

  readonly dropOwnSettings = (): void => {
    this.#ofSketch.value = null;
  };

  readonly removeKept = async (id: string): Promise<void> => {
    if (!(await this.shelf.remove(id))) {
      this.toaster.error(text.tabs.notRemoved);
    }
  };

  /** Offers the sketch as a file, where the browser keeps none. */
  warn(message: string): void {
    this.toaster.error(message, { label: text.files.download, run: this.files.saveSketch });
  }

  /** Puts another sketch on the page; undo brings the old one back. */
  replaceSketch(sketch: SketchDocument, settings: SearchSettings | null = null): void {
    this.state.tool.value.reset();
    this.run.clear();
    this.state.focusedProblem.value = null;
    this.#opened = sketch;
    this.shelf.leave(sketch, settings);
    this.state.came.value = null;
    this.edit(text.edits.open, sketch);
    this.useTool('select');
    this.fit();
  }

  readonly openExample = (example: Example, made: MadeParts | null = null): void => {
    const sketch = namedSketch(example);
    this.replaceSketch(sketch);
    this.state.came.value = sketch;
    if (made && same(made.settings, settingsOf(this.state.preferences.value))) {
      const model = { ...made, sketch, layoutJson: null };
      this.run.showMade(model);
      this.run.confirm(model).catch(() => undefined);
    } else {
      this.generate();
    }
  };

  // --- Search --------------------------------------------------------------------------------

  readonly generate = (): void => {
    const sketch = this.state.store.sketch.value;
    this.state.focusedProblem.value = null;
    this.run.start(sketch, settingsOf(this.state.preferences.value)).catch(() => undefined);
  };

  /** After an edit: the model goes on from the one before. */
  readonly regrow = (): void => {
    const sketch = this.state.store.sketch.value;
    this.state.focusedProblem.value = null;
    this.run.regrow(sketch, settingsOf(this.state.preferences.value)).catch(() => undefined);
  };

  readonly showLayout = (layout: LayoutSnapshot): void => {
    this.run.showLayout(layout).catch(() => undefined);
  };

  readonly cancel = (): void => this.run.cancel();

  // --- View ----------------------------------------------------------------------------------

  readonly fit = (): void => {
    // After the scene has taken the new sketch, which it does when the signals have settled.
    setTimeout(() => this.scene.view?.fit(), TURN_BACK_MS);
  };

  /** The first model of a sketch is larger than its lines: the picture is fitted to it once. */
  fitFirstModels(): void {
    let fitted: SketchDocument | null = null;
    effect(() => {
      const shown = this.state.shown.value;
      const opened = this.#opened;
      if (shown?.report && opened && opened !== fitted) {
        fitted = opened;
        this.fit();
      }
    });
  }

  /** Resolves when the model shown is on screen, and marks that in the browser's timeline. */
  modelDrawn(): Promise<void> {
    return new Promise((resolve) => {
      const stop = effect(() => {
        const { shown } = this.state;
        const { drawnModel, webglMissing } = this.scene;
        const drawn = shown.value?.report && drawnModel.value === shown.value.model;
        if (drawn || (shown.value?.report && webglMissing.value)) {
          performance.mark(FIRST_MODEL);
          resolve();
          queueMicrotask(() => stop());
        }
      });
    });
  }

  readonly cutAlong = (axis: AxisName | null): void => {
    const { section, shown, catalogue } = this.state;
    const box = axis && shown.value ? modelBounds(shown.value.model, catalogue) : null;
    section.value = axis && box ? { axis, offset: middleAlong(box, axis) } : null;
  };

  readonly moveCamera = ({ factor, right, up }: CameraMove): void => {
    const { view } = this.scene;
    if (factor !== 1) {
      view?.zoom(factor);
    }
    if (right !== 0 || up !== 0) {
      view?.turn(right, up);
    }
  };

  readonly toggleKind = (kind: PartKind): void => {
    const { isolation } = this.state;
    const parts = new Set(this.state.partsOf(kind));
    const same =
      isolation.value?.parts.size === parts.size &&
      [...parts].every((index) => isolation.value?.parts.has(index));
    isolation.value = same ? null : { parts, others: 'ghost' };
  };

  readonly setView = (view: StandardView): void => {
    this.scene.view?.fit(view);
  };

  readonly focusProblem = (index: number): void => {
    const { focusedProblem, result } = this.state;
    const same = focusedProblem.value === index;
    focusedProblem.value = same ? null : index;
    const problem = same ? null : result.value?.problems[index];
    if (problem) {
      this.announce(inWords(problem.message));
      this.scene.showPlace(problem);
    }
  };

  readonly typeLength = (value: string): void => {
    this.state.tool.value.type?.(value);
  };

  #toolOf(id: ToolId): Tool {
    const tool = this.#tools.get(id);
    if (!tool) {
      throw new RangeError(`no tool ${id}`);
    }
    return tool;
  }
}
