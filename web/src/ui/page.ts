import type { ReadonlySignal, Signal } from '@preact/signals';
import type { AxisName, Vec3 } from '../geometry/vec.ts';
import type { Catalogue } from '../model/catalogue.ts';
import type { PartCount } from '../model/counts.ts';
import type { FoundSymmetry } from '../model/found-symmetries.ts';
import type { Place } from '../model/keep.ts';
import type { Model } from '../model/model.ts';
import type { PartsList } from '../model/parts-list.ts';
import type { CheckItem, CheckReport, Problem, Report, WellBuilt } from '../model/report.ts';
import type { SketchDocument, SketchSymmetry } from '../model/sketch.ts';
import type { MadeParts } from '../solver/made-file.ts';
import type { MadeModel } from '../solver/made-model.ts';
import type { SolveProgress } from '../solver/protocol.ts';
import type { JointPlace } from '../state/joint-edits.ts';
import type { LegalOffer } from '../state/legal-offer.ts';
import type { LibraryEntry } from '../state/library.ts';
import type { PagePreferences } from '../state/page-preferences.ts';
import type { SearchSettings } from '../state/search-settings.ts';
import type { SketchFault } from '../state/sketch-faults.ts';
import type { SketchStore } from '../state/store.ts';
import type { PointerInput, Tool, ToolId } from '../tools/tool.ts';
import type { SceneView } from '../view/scene-view.ts';
import type { Isolation, PartDisplay, Section } from '../view/view-types.ts';
import type { CommandTable } from './command.ts';
import type { Fits, Trial } from './touch/touch-types.ts';

/** How the last search ended, or that one is under way. */
export type SolvePhase = 'idle' | 'solving' | 'solved' | 'cancelled' | 'refused' | 'failed';

/** One point of the chart. */
export type ChartPoint = Pick<
  SolveProgress,
  | 'iterations'
  | 'objective'
  | 'temperature'
  | 'beams'
  | 'gaps'
  | 'collisions'
  | 'failedConnections'
  | 'terms'
>;

/** A layout that was the best for a while. */
export interface LayoutSnapshot extends ChartPoint {
  /** The model file of it. */
  readonly json: string;
}

/** What the solve section shows. */
export interface SolveState {
  readonly phase: SolvePhase;
  readonly progress: SolveProgress | null;
  readonly chart: readonly ChartPoint[];
  /** The best layouts so far, the newest last; see MAX_LAYOUTS. */
  readonly layouts: readonly LayoutSnapshot[];
  /** One sentence for `refused`, `failed` and `cancelled`. */
  readonly message: string;
}

/** A part number in one colour. */
export type PartKind = Pick<PartCount, 'part' | 'color'>;

/** A part of the parts list with what is needed to show it. */
export interface PartRow extends PartCount {
  readonly name: string;
  readonly colourName: string;
  /** CSS colour. */
  readonly swatch: string;
}

/** The result that is on screen. */
export interface ResultState {
  readonly source: 'search' | 'file';
  readonly name: string;
  readonly report: Report;
  readonly items: readonly CheckItem[];
  readonly problems: readonly Problem[];
  /** Null while the search is under way. */
  readonly wellBuilt: WellBuilt | null;
  readonly buildable: boolean;
  readonly rows: readonly PartRow[];
  readonly bricks: number;
  /** False while the search that made it is still under way. */
  readonly final: boolean;
}

/** A model on screen, and what is known of it. */
export interface ShownModel {
  readonly source: 'search' | 'file';
  /** The model file, as it was computed or opened. */
  readonly json: string;
  readonly model: Model;
  /** The sketch it was made for; null for a model from a file that names none. */
  readonly sketch: SketchDocument | null;
  /** The parts that its search might use (partsText); null for a model from a file. */
  readonly parts: string | null;
  /** Null while the search is under way. */
  readonly report: Report | null;
  readonly check: CheckReport | null;
}

/** An edit that takes hold of the model. */
export interface ModelEdit {
  readonly label: string;
  readonly next: SketchDocument;
  /** The part that was taken hold of, if any, and where it will lie; null: it will not. */
  readonly index: number | null;
  readonly place: Place | null;
}

/** Somebody who wants presses in the scene before the tools and the camera get them. */
export interface PointerTaker {
  /** @returns whether it takes this press, and with it the moves up to the release. */
  pressed(at: PointerInput): boolean;
  moved(at: PointerInput): void;
  /** The press ended, or was broken off. */
  released(at: PointerInput | null): void;
}

export interface Example {
  readonly file: string;
  readonly title: string;
  readonly description: string;
  readonly sketch: SketchDocument;
}

export interface OwnedList {
  /** Of the file. */
  readonly name: string;
  readonly list: PartsList;
}

export interface Toast {
  readonly id: number;
  readonly kind: 'info' | 'error';
  readonly message: string;
  /** What can be done about it. */
  readonly action?: { readonly label: string; readonly run: () => void };
}

export type DialogName =
  | 'menu'
  | 'alternatives'
  | 'bricks'
  | 'palette'
  | 'help'
  | 'examples'
  | 'legal'
  | 'sketches'
  | 'about'
  | null;

/** The sketches that this browser keeps. */
export interface SketchLibraryPage {
  list(): Promise<readonly LibraryEntry[]>;
  openId(): string;
  open(id: string): void;
  duplicate(id: string): Promise<void>;
  remove(id: string): Promise<void>;
}

/** What a model was searched with beside what is in force. */
export type TakenSettings = Pick<SearchSettings, 'preset' | 'seed'> &
  Partial<Pick<SearchSettings, 'advanced'>>;

/** Everything that the panels read, and the few things they do that are no commands. */
export interface Page {
  readonly commands: CommandTable;
  readonly store: SketchStore;
  readonly preferences: PagePreferences;
  /** Whether the sketch on the page brought search settings of its own. */
  readonly ownSettings: ReadonlySignal<boolean>;
  /** The sketch is searched with the person's settings from now on. */
  dropOwnSettings(): void;
  readonly tool: ReadonlySignal<Tool>;
  /** The joint that is being changed, with the tool for joints. */
  readonly joint: Signal<JointPlace | null>;
  /** Why the joints of the sketch cannot be had together, as the core says it; null where they can. */
  readonly jointRefusal: ReadonlySignal<string | null>;
  readonly solve: ReadonlySignal<SolveState>;
  readonly result: ReadonlySignal<ResultState | null>;
  /** The model was made for another sketch than the one on screen. */
  readonly stale: ReadonlySignal<boolean>;
  /** What has changed since the model on screen was searched for. */
  readonly staleBy: ReadonlySignal<'drawing' | 'parts' | null>;
  /** The sketch is small enough to be solved after each edit. */
  readonly small: ReadonlySignal<boolean>;
  readonly catalogue: Catalogue;
  /** The model on screen; while a search is under way, its best layout so far. */
  readonly shown: ReadonlySignal<ShownModel | null>;
  readonly explode: Signal<number>;
  /**
   * How parts are drawn in place of how the model has them: motion, steps, results of checks. Set it
   * while yours is open and set null when it closes; another model clears it.
   */
  readonly display: Signal<PartDisplay | null>;
  readonly isolation: Signal<Isolation | null>;
  readonly section: Signal<Section | null>;
  /** The card that moves, copies and mirrors lines by numbers. */
  readonly offsetOpen: Signal<boolean>;
  /** Lines that somebody is about to draw otherwise than with a tool. */
  readonly ghostLines: Signal<readonly (readonly [Vec3, Vec3])[]>;
  /** Set while something in the scene can be dragged, null otherwise. */
  readonly pointerTaker: Signal<PointerTaker | null>;
  /** The place that is open by its name in the address, null for the drawing; see ui/places.ts. */
  readonly room: ReadonlySignal<string | null>;
  readonly examples: ReadonlySignal<readonly Example[] | null>;
  readonly dialog: Signal<DialogName>;
  readonly toasts: ReadonlySignal<readonly Toast[]>;
  readonly announcement: ReadonlySignal<string>;
  /** Somebody else's sketch is on the page, and nothing was changed in it. */
  readonly lookedAt: ReadonlySignal<boolean>;
  /** What is most likely not meant in the drawing. */
  readonly faults: ReadonlySignal<readonly SketchFault[]>;
  /** What brings the sketch onto itself and is not kept yet. */
  readonly foundSymmetries: ReadonlySignal<readonly FoundSymmetry[]>;
  /** The one that is shown because somebody is about to confirm it. */
  readonly proposedSymmetry: Signal<FoundSymmetry | null>;
  /** The nearest drawing to a refused one, while a person looks at it. */
  readonly legalOffer: ReadonlySignal<LegalOffer | null>;
  /** Takes that. */
  takeLegal(): void;
  /** Looks for a part that fits where one does not, in the model of a file. */
  mendModel(): void;
  /** A list of parts that was read, until a person takes it or not. */
  readonly ownedList: Signal<OwnedList | null>;
  readonly panelOpen: Signal<boolean>;
  readonly dropping: ReadonlySignal<boolean>;
  readonly webglMissing: ReadonlySignal<boolean>;
  readonly focusedProblem: ReadonlySignal<number | null>;
  readonly hoveredPart: ReadonlySignal<string | null>;
  /** The line of the parts list that is pointed at. */
  readonly listedPart: Signal<PartKind | null>;
  /** Shows the parts of a kind alone, or all again. */
  toggleKind(kind: PartKind): void;
  /** The brick that was clicked, by index. */
  readonly pickedPart: Signal<number | null>;
  /** Where each part of the model shown lies on the lines; null until that is known. */
  readonly places: ReadonlySignal<readonly (Place | null)[] | null>;
  /** Puts an edit of what is kept into the history, and solves the rest around it at once. */
  touchModel(touch: ModelEdit): void;
  /** What else could lie where a part does; null where nothing is known of it. */
  fits(part: number, signal: AbortSignal): Promise<Fits | null>;
  /** What a part in place of another makes of the model. */
  tryPart(before: Place, after: Place, signal: AbortSignal): Promise<Trial>;
  readonly mac: boolean;
  /** Gives the element that the scene is drawn into. @returns what to do when it goes away. */
  mountScene(host: HTMLElement): () => void;
  /** The scene: overlays, pictures, places on screen. Null before it is there, or without WebGL. */
  view(): SceneView | null;
  /** @param id a place or a room; null goes back to the drawing. */
  openRoom(id: string | null): void;
  readonly sketches: SketchLibraryPage;
  /** Says a sentence to screen readers. */
  announce(message: string): void;
  useTool(id: ToolId): void;
  /** Gives the keys to the drawing. */
  focusDrawing(): void;
  /** Opens a drawing. @param made its model, shown at once where the settings are those that it was made with. */
  openExample(example: Example, made?: MadeParts | null): void;
  /** Shows another model of the drawing, and searches with the settings that made it from then on. */
  takeModel(made: MadeModel, search: TakenSettings): void;
  openFile(file: File): void;
  focusProblem(index: number): void;
  /** Lets a person choose a list of the parts that there are. */
  importOwned(): void;
  /** Address of a picture of a part. Rejects without WebGL. */
  partPicture(id: string): Promise<string>;
  /** Cuts the model open in its middle; null closes it. */
  cutAlong(axis: AxisName | null): void;
  /** Brings a place to the middle of the picture. */
  showPlace(at: Vec3): void;
  /** Shows an earlier layout of the last search. */
  showLayout(layout: LayoutSnapshot): void;
  mend(fault: SketchFault): void;
  confirmSymmetry(symmetry: SketchSymmetry): void;
  dropSymmetry(index: number): void;
  rename(name: string): void;
  dismissToast(id: number): void;
  /** Typed into the size field of the options bar: what stands in it now. */
  typeLength(value: string): void;
}
