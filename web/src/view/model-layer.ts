import { Group } from 'three';
import { add, ORIGIN, scale, subtract, type Vec3 } from '../geometry/vec.ts';
import { type Bounds, boundsOfPoints, modelBounds, modelCorners } from '../model/bounds.ts';
import { mixHex } from '../model/colours.ts';
import type { Model, PlacedPart } from '../model/model.ts';
import { type BatchStyle, BrickBatch } from './brick-batch.ts';
import type { BrickLibrary } from './bricks/brick-library.ts';
import type { BrickMaterials } from './bricks/brick-materials.ts';
import type { DetailName } from './bricks/detail.ts';
import { schemeHex } from './colour-scheme.ts';
import { chooseDetail } from './level-of-detail.ts';
import { pickPart } from './part-picking.ts';
import type { ColourScheme, Isolation, PartDisplay, PartPick, Ray } from './view-types.ts';

/** Parts that stand out: hovered and selected ones, by index. */
export interface PartMarks {
  readonly selected?: ReadonlySet<number>;
  readonly hovered?: number | null;
  readonly errors?: ReadonlySet<number>;
}

/** Paleness of some parts, or of all. */
interface Fade {
  /** sRGB. */
  readonly towards: number;
  readonly only: true | ReadonlySet<number>;
}

/** How pale faded parts become: 1 would be the colour that they fade towards. */
const FADE_AMOUNT = 0.62;
/** How far an exploded model spreads at most, as a multiple of its size. */
const EXPLODE_SPREAD = 0.9;

/** Of a frame, in which geometry of new parts is built; more while no model was seen yet. */
const BUILD_MS = { first: 40, later: 10 } as const;

/** All bricks of one part and style that are to be drawn. */
interface Members {
  readonly partId: string;
  readonly style: BatchStyle;
  readonly indices: number[];
}

/** Any level will do until the right one is built: the finest first. */
const FALLBACKS: readonly DetailName[] = ['high', 'medium', 'low', 'ultra'];

/**
 * The placed parts of one model as instanced bricks. Geometry of parts that were not seen before takes
 * long to build: `in-slices` leaves it to advance(), so that no frame waits for all of it.
 */
export class ModelLayer {
  readonly group = new Group();
  readonly #library: BrickLibrary;
  readonly #materials: BrickMaterials;
  #model: Model | null = null;
  #batches: BrickBatch[] = [];
  /** What waits for its geometry and is not drawn yet. */
  #waiting: Members[] = [];
  readonly #pace: 'at-once' | 'in-slices';
  #bounds: Bounds | null = null;
  /** No model was there as a whole yet. */
  #unseen = true;
  #detail: DetailName = 'high';
  #scheme: ColourScheme = 'part';
  #marks: PartMarks = {};
  #isolation: Isolation | null = null;
  #display: PartDisplay = {};
  /** The model's parts where they stand now: as built, or as the display has them. */
  #parts: readonly PlacedPart[] = [];
  #explode = 0;
  #linesVisible = true;
  #fade: Fade | null = null;

  constructor(
    library: BrickLibrary,
    materials: BrickMaterials,
    pace: 'at-once' | 'in-slices' = 'at-once',
  ) {
    this.#library = library;
    this.#materials = materials;
    this.#pace = pace;
  }

  get model(): Model | null {
    return this.#model;
  }

  /** The model, if every part of it is drawn, at whatever level of detail. */
  get wholeModel(): Model | null {
    return this.#waiting.length === 0 ? this.#model : null;
  }

  /** Box around the parts as drawn, exploded or not; null without parts. */
  get bounds(): Bounds | null {
    return this.#explode > 0 ? boundsOfPoints(this.corners()) : this.#bounds;
  }

  /** Corners of the parts' boxes as drawn, exploded or not. */
  corners(): Vec3[] {
    const model = this.#model;
    return model ? modelCorners(this.#explodedModel(model), this.#library.catalogue) : [];
  }

  /** Triangles of all bricks shown, at a level of detail; about, while not all of them are built. */
  trianglesAt(detail: DetailName): number {
    const triangles = (partId: string): number => {
      if (this.#pace === 'at-once') {
        this.#library.get(partId, detail);
      }
      return this.#library.triangles(partId, detail);
    };
    const drawn = this.#batches.map(({ partId, members }) => triangles(partId) * members.length);
    const due = this.#waiting.map(({ partId, indices }) => triangles(partId) * indices.length);
    return [...drawn, ...due].reduce((sum, value) => sum + value, 0);
  }

  setModel(model: Model | null): void {
    this.#model = model;
    this.#display = {};
    this.#parts = model?.parts ?? [];
    this.#bounds = model ? modelBounds(model, this.#library.catalogue) : null;
    this.#rebuild();
  }

  /** Mixes colours towards one; null gives them back. */
  setFade(fade: Fade | null): void {
    const before = this.#fade;
    this.#fade = fade;
    if (before?.only === fade?.only && before?.towards === fade?.towards) {
      return;
    }
    this.#paint();
  }

  setColourScheme(scheme: ColourScheme): void {
    this.#scheme = scheme;
    this.#paint();
  }

  setMarks(marks: PartMarks): void {
    this.#marks = marks;
    this.#paint();
  }

  setIsolation(isolation: Isolation | null): void {
    this.#isolation = isolation;
    this.#rebuild();
  }

  /**
   * Draws parts otherwise than the model has them; null ends that. Only what differs from the last
   * time is done again, so that poses may change with every frame.
   */
  setDisplay(display: PartDisplay | null): void {
    const before = this.#display;
    this.#display = display ?? {};
    if (before.poses !== this.#display.poses) {
      this.#parts = posedParts(this.#model?.parts ?? [], this.#display.poses);
    }
    if (before.looks !== this.#display.looks) {
      this.#rebuild();
      return;
    }
    if (before.poses !== this.#display.poses) {
      this.#place();
    }
    if (
      before.colours !== this.#display.colours ||
      before.highlighted !== this.#display.highlighted
    ) {
      this.#paint();
    }
  }

  /** Moves parts apart from the middle of the model. @param amount 0 (as built) to 1. */
  setExplode(amount: number): void {
    this.#explode = Math.min(1, Math.max(0, amount));
    this.#place();
  }

  /**
   * The level of detail, and how strong the lines are, for bricks of this size on screen.
   * @returns true when the level changed.
   */
  suit(pixelsPerModule: number): boolean {
    const choice = chooseDetail(pixelsPerModule, (detail) => this.trianglesAt(detail));
    this.setLinesVisible(choice.lineOpacity > 0);
    this.#materials.setLineOpacity(choice.lineOpacity);
    return this.setDetail(choice.detail);
  }

  /** @returns true when the level changed. */
  setDetail(detail: DetailName): boolean {
    if (detail === this.#detail) {
      return false;
    }
    this.#detail = detail;
    if (this.#pace === 'at-once') {
      for (const batch of this.#batches) {
        batch.setDetail(detail);
      }
    }
    return true;
  }

  /** As long as there was nothing to look at, parts come before the picture. @returns as advance(). */
  buildBeforeFrame(): boolean {
    return this.#unseen && this.advance(BUILD_MS.first);
  }

  /** @returns as advance(). */
  buildAfterFrame(): boolean {
    return this.advance(BUILD_MS.later);
  }

  /**
   * Builds what is still missing at the present level of detail, one part at least, until the time is up.
   * @param milliseconds Infinity builds all of it.
   * @returns whether anything is drawn otherwise than before, so that another frame is due.
   */
  advance(milliseconds: number): boolean {
    const until = performance.now() + milliseconds;
    let changed = false;
    while (this.#buildNext()) {
      changed = true;
      if (performance.now() >= until) {
        break;
      }
    }
    this.#unseen &&= this.wholeModel === null;
    return changed;
  }

  /** What is not drawn at all comes before what is drawn at another level. */
  #buildNext(): boolean {
    const members = this.#waiting.shift();
    if (members) {
      this.#library.get(members.partId, this.#detail);
      this.#addBatch(members, this.#detail);
      return true;
    }
    const batch = this.#batches.find(({ detail }) => detail !== this.#detail);
    batch?.setDetail(this.#detail);
    return batch !== undefined;
  }

  setLinesVisible(visible: boolean): void {
    this.#linesVisible = visible;
    for (const batch of this.#batches) {
      batch.setLinesVisible(visible);
    }
  }

  /** The nearest part that the ray meets among those shown, or null. */
  pick(ray: Ray): PartPick | null {
    if (!this.#model || !this.group.visible) {
      return null;
    }
    return pickPart(ray, this.#parts, {
      library: this.#library,
      shift: (index) => this.#shift(index),
      isPickable: (index) => this.#styleOf(index) === 'solid',
    });
  }

  /** Middle of a part as drawn, modules. */
  partCentre(index: number): Vec3 | null {
    const part = this.#parts[index];
    return part ? add(part.position, this.#shift(index)) : null;
  }

  dispose(): void {
    this.#clear();
  }

  #clear(): void {
    for (const batch of this.#batches) {
      batch.dispose();
    }
    this.#batches = [];
    this.#waiting = [];
  }

  #rebuild(): void {
    this.#clear();
    const members = new Map<string, Members>();
    this.#model?.parts.forEach((part, index) => {
      const style = this.#styleOf(index);
      if (style === 'hidden' || !this.#library.catalogue.find(part.part)) {
        return;
      }
      const key = `${style}/${part.part}`;
      const known = members.get(key);
      if (known) {
        known.indices.push(index);
      } else {
        members.set(key, { partId: part.part, style, indices: [index] });
      }
    });
    for (const group of members.values()) {
      const detail = this.#readyDetail(group.partId);
      if (detail) {
        this.#addBatch(group, detail);
      } else {
        this.#waiting.push(group);
      }
    }
  }

  /** The level at which a part can be drawn without a wait, or null. */
  #readyDetail(partId: string): DetailName | null {
    if (this.#pace === 'at-once' || this.#library.built(partId, this.#detail)) {
      return this.#detail;
    }
    return FALLBACKS.find((name) => this.#library.built(partId, name)) ?? null;
  }

  #addBatch({ partId, style, indices }: Members, detail: DetailName): void {
    const content = { partId, members: indices, style, detail };
    const batch = new BrickBatch(this.#library, this.#materials, content);
    batch.addTo(this.group);
    batch.setLinesVisible(this.#linesVisible);
    this.#batches.push(batch);
    this.#placeBatch(batch);
    this.#paintBatch(batch);
  }

  #styleOf(index: number): BatchStyle | 'hidden' {
    const look = this.#display.looks?.get(index);
    if (look) {
      return look;
    }
    const isolation = this.#isolation;
    if (!isolation || isolation.parts.has(index)) {
      return 'solid';
    }
    return isolation.others === 'ghost' ? 'ghost' : 'hidden';
  }

  #place(): void {
    for (const batch of this.#batches) {
      this.#placeBatch(batch);
    }
  }

  #placeBatch(batch: BrickBatch): void {
    batch.place(this.#parts, (index) => this.#shift(index));
  }

  #shift(index: number): Vec3 {
    const part = this.#model?.parts[index];
    if (!part || !this.#bounds || this.#explode === 0) {
      return ORIGIN;
    }
    const middle = scale(add(this.#bounds.min, this.#bounds.max), 0.5);
    return scale(subtract(part.position, middle), this.#explode * EXPLODE_SPREAD);
  }

  #explodedModel(model: Model): Model {
    const moved = this.#parts.map((part, index) => ({
      ...part,
      position: add(part.position, this.#shift(index)),
    }));
    return { ...model, parts: moved };
  }

  #paint(): void {
    for (const batch of this.#batches) {
      this.#paintBatch(batch);
    }
  }

  #paintBatch(batch: BrickBatch): void {
    const parts = this.#model?.parts ?? [];
    batch.paint((index) => this.#colourOf(parts[index], index));
  }

  #colourOf(part: PlacedPart | undefined, index: number): number {
    if (!part) {
      return 0;
    }
    const given = this.#display.colours?.[index] ?? null;
    let hex = given ?? schemeHex(part, this.#scheme, this.#library.catalogue);
    if (this.#fade && (this.#fade.only === true || this.#fade.only.has(index))) {
      hex = mixHex(hex, this.#fade.towards, FADE_AMOUNT);
    }
    if (this.#marks.errors?.has(index)) {
      hex = mixHex(hex, MARK_HEX.error, 0.7);
    }
    if (this.#marks.selected?.has(index) || this.#display.highlighted?.has(index)) {
      hex = mixHex(hex, MARK_HEX.selected, 0.65);
    }
    return this.#marks.hovered === index ? mixHex(hex, MARK_HEX.hovered, 0.4) : hex;
  }
}

const MARK_HEX = { error: 0xe5484d, selected: 0x2f7de1, hovered: 0x7db4f5 } as const;

/** Parts with those moved that have a pose. */
function posedParts(
  parts: readonly PlacedPart[],
  poses: PartDisplay['poses'],
): readonly PlacedPart[] {
  return poses
    ? parts.map((part, index) => {
        const pose = poses.get(index);
        return pose ? { ...part, ...pose } : part;
      })
    : parts;
}
