import { computed, type ReadonlySignal, type Signal, signal } from '@preact/signals';
import type { Vec3 } from '../geometry/vec.ts';
import type { Catalogue } from '../model/catalogue.ts';
import { colourHex } from '../model/colours.ts';
import { countParts } from '../model/counts.ts';
import { unfitParts } from '../model/fitting-parts.ts';
import type { FoundSymmetry } from '../model/found-symmetries.ts';
import type { Report } from '../model/report.ts';
import { lineLength, type SketchDocument } from '../model/sketch.ts';
import type { JointPlace } from '../state/joint-edits.ts';
import type { LegalOffer } from '../state/legal-offer.ts';
import type { PagePreferences } from '../state/page-preferences.ts';
import { isLoud, type SketchFault } from '../state/sketch-faults.ts';
import type { SketchStore } from '../state/store.ts';
import type { PlaneMode, Tool } from '../tools/tool.ts';
import type {
  DialogName,
  Example,
  OwnedList,
  PartKind,
  PartRow,
  PointerTaker,
  ResultState,
  ShownModel,
  SolveState,
} from '../ui/page.ts';
import { partsText, settingsOf } from '../ui/solve-settings.ts';
import { colourWord, partName } from '../ui/text/part-names.ts';
import type { Isolation, PartDisplay, Section } from '../view/view-types.ts';

/** Up to this size a sketch is solved after each edit: a second or two on a slow machine. */
const SMALL = { lines: 80, length: 500 } as const;

interface PageStateOptions {
  readonly store: SketchStore;
  readonly preferences: PagePreferences;
  readonly catalogue: Catalogue;
  readonly solve: ReadonlySignal<SolveState>;
  readonly shown: ReadonlySignal<ShownModel | null>;
  readonly tool: Signal<Tool>;
  readonly planeMode: Signal<PlaneMode>;
  readonly joint: Signal<JointPlace | null>;
  readonly ownSettings: ReadonlySignal<boolean>;
}

/** All signals of the page, and what follows from them. */
export class PageState {
  readonly store: SketchStore;
  readonly preferences: PagePreferences;
  readonly solve: ReadonlySignal<SolveState>;
  readonly shown: ReadonlySignal<ShownModel | null>;
  readonly tool: Signal<Tool>;
  readonly planeMode: Signal<PlaneMode>;
  readonly ownSettings: ReadonlySignal<boolean>;
  readonly catalogue: Catalogue;
  readonly explode = signal(0);
  readonly display = signal<PartDisplay | null>(null);
  readonly isolation = signal<Isolation | null>(null);
  readonly section = signal<Section | null>(null);
  readonly offsetOpen = signal(false);
  readonly ghostLines = signal<readonly (readonly [Vec3, Vec3])[]>([]);
  readonly pointerTaker = signal<PointerTaker | null>(null);
  /** The joint that is being changed. */
  readonly joint: Signal<JointPlace | null>;
  /** Why the joints of the sketch cannot be had together, as the core says it; null where they can. */
  readonly jointRefusal = signal<string | null>(null);
  readonly room = signal<string | null>(null);
  readonly dialog = signal<DialogName>(null);
  readonly examples = signal<readonly Example[] | null>(null);
  readonly announcement = signal('');
  /** Found in the sketch a moment after each edit; see sketch-watch.ts. */
  readonly faults = signal<readonly SketchFault[]>([]);
  readonly foundSymmetries = signal<readonly FoundSymmetry[]>([]);
  readonly proposedSymmetry = signal<FoundSymmetry | null>(null);
  /** The sketch as it came, by an example or a link; null for one's own. */
  readonly came = signal<SketchDocument | null>(null);
  readonly legalOffer = signal<LegalOffer | null>(null);
  readonly ownedList = signal<OwnedList | null>(null);
  readonly panelOpen = signal(false);
  readonly dropping = signal(false);
  readonly focusedProblem = signal<number | null>(null);
  readonly hoveredPartIndex = signal<number | null>(null);
  /** The line of the parts list that is pointed at. */
  readonly listedPart = signal<PartKind | null>(null);
  /** The brick that was clicked, by index. */
  readonly pickedPart = signal<number | null>(null);
  readonly systemDark = signal(false);

  readonly result: ReadonlySignal<ResultState | null>;
  readonly stale: ReadonlySignal<boolean>;
  readonly staleBy: ReadonlySignal<'drawing' | 'parts' | null>;
  /** Somebody else's sketch is on the page, and nothing was changed in it. */
  readonly lookedAt: ReadonlySignal<boolean>;
  /** Parts of the model that the sketch has left behind: none, some, or all. */
  readonly unfit: ReadonlySignal<boolean | ReadonlySet<number>>;
  readonly small: ReadonlySignal<boolean>;
  readonly themeName: ReadonlySignal<'light' | 'dark'>;
  /** Where something is wrong in the sketch or in the model made for it. */
  readonly problemPoints: ReadonlySignal<readonly Vec3[]>;
  /** Lines that look joined and are not, and those that were refused. */
  readonly problemLines: ReadonlySignal<ReadonlySet<number>>;
  readonly hoveredPart: ReadonlySignal<string | null>;
  readonly partMarks: ReadonlySignal<{
    readonly hovered: number | null;
    readonly selected: ReadonlySet<number>;
    readonly errors: ReadonlySet<number>;
  }>;

  constructor(options: PageStateOptions) {
    const { store, preferences, catalogue, solve, shown } = options;
    this.store = store;
    this.catalogue = catalogue;
    this.preferences = preferences;
    this.solve = solve;
    this.shown = shown;
    this.tool = options.tool;
    this.planeMode = options.planeMode;
    this.joint = options.joint;
    this.ownSettings = options.ownSettings;
    this.result = computed(() => {
      const model = shown.value;
      return model && resultOf(model, catalogue);
    });
    const sketchText = computed(() => searchText(store.sketch.value));
    const shownText = computed(() => {
      const sketch = shown.value?.sketch;
      return sketch ? searchText(sketch) : null;
    });
    const parts = computed(() => partsText(settingsOf(preferences.value)));
    this.staleBy = computed(() => {
      if (shownText.value !== null && shownText.value !== sketchText.value) {
        return 'drawing';
      }
      const used = shown.value?.parts ?? null;
      return used !== null && used !== parts.value ? 'parts' : null;
    });
    this.stale = computed(() => this.staleBy.value !== null);
    this.lookedAt = computed(
      () => this.came.value !== null && this.came.value === store.sketch.value,
    );
    this.unfit = computed(() => {
      const model = shown.value;
      return this.stale.value && model?.sketch
        ? (unfitParts(model.model.parts, model.sketch, store.sketch.value) ?? true)
        : false;
    });
    this.small = computed(() => isSmall(store.sketch.value));
    this.themeName = computed(() => {
      const { theme } = preferences.value;
      return theme === 'auto' ? (this.systemDark.value ? 'dark' : 'light') : theme;
    });
    this.problemPoints = settled(() => {
      const problems = this.stale.value ? [] : (this.result.value?.problems ?? []);
      const ofModel = problems.flatMap((problem) => (problem.at ? [problem.at] : []));
      return [...ofModel, ...this.faults.value.filter(isLoud).map((fault) => fault.at)];
    });
    const faultyLines = settled(() => {
      const { phase, message } = solve.value;
      const refused = phase === 'refused' ? refusedLine(message) : null;
      const faulty = this.faults.value.filter(isLoud).flatMap((fault) => fault.lines);
      return refused === null ? faulty : [...faulty, refused];
    });
    this.problemLines = computed(() => new Set(faultyLines.value));
    this.hoveredPart = computed(() => {
      const index = this.hoveredPartIndex.value;
      return index === null ? null : (shown.value?.model.parts[index]?.part ?? null);
    });
    this.partMarks = computed(() => {
      const focused = this.focusedProblem.value;
      const problem = focused === null ? null : this.result.value?.problems[focused];
      const picked = this.pickedPart.value;
      return {
        hovered: this.hoveredPartIndex.value,
        selected: new Set([
          ...(picked === null ? [] : [picked]),
          ...this.partsOf(this.listedPart.value),
        ]),
        errors: new Set(problem?.parts ?? []),
      };
    });
  }
  /** Indices of all parts of a kind in the model on screen. */
  partsOf(kind: PartKind | null): number[] {
    const parts = kind ? (this.shown.value?.model.parts ?? []) : [];
    return parts.flatMap((part, i) =>
      part.part === kind?.part && part.color === kind.color ? [i] : [],
    );
  }

  /** Part indices mean nothing for another model. */
  forgetParts(): void {
    this.display.value = null;
    this.isolation.value = null;
    this.focusedProblem.value = null;
    this.hoveredPartIndex.value = null;
    this.pickedPart.value = null;
    this.listedPart.value = null;
  }
}

/** A list that stays the same object while it says the same: who draws it has nothing to do then. */
function settled<T>(list: () => readonly T[]): ReadonlySignal<readonly T[]> {
  let last: readonly T[] = [];
  return computed(() => {
    const next = list();
    const same = JSON.stringify(next) === JSON.stringify(last);
    last = same ? last : next;
    return last;
  });
}

/** The text of a sketch without its name: equal texts give equal models. */
export function searchText(sketch: SketchDocument): string {
  const { name: _name, ...rest } = sketch;
  return JSON.stringify(rest);
}

export function isSmall(sketch: SketchDocument): boolean {
  const length = sketch.lines.reduce((sum, line) => sum + lineLength(line), 0);
  return sketch.lines.length <= SMALL.lines && length <= SMALL.length;
}

function resultOf(shown: ShownModel, catalogue: Catalogue): ResultState {
  const { report, check, model } = shown;
  return {
    source: shown.source,
    name: model.name,
    report: report ?? {},
    items: check?.items ?? [],
    // The report's name the cause too; a file has none.
    problems: report?.problems ?? check?.problems ?? [],
    wellBuilt: check?.wellBuilt ?? null,
    buildable: check ? check.buildable && !leftUndone(report) : (report?.buildable ?? false),
    rows: countParts(model).map(
      (row): PartRow => ({
        ...row,
        name: partName(row.part, catalogue),
        colourName: colourWord(row.color),
        swatch: `#${colourHex(row.color).toString(16).padStart(6, '0')}`,
      }),
    ),
    bricks: model.parts.length,
    final: report !== null,
  };
}

/** Whether the search knows of a place where it failed, though what it laid holds; parts to buy are no such. */
function leftUndone(report: Report | null): boolean {
  return report?.problems?.some(({ kind }) => kind !== 'owned') ?? false;
}

/** The line that a refusal of the core names, such as `lines[3]: …`, or null. */
export function refusedLine(message: string): number | null {
  const match = /^lines\[(\d+)\]/.exec(message);
  return match ? Number(match[1]) : null;
}
