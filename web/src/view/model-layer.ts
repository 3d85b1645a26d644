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
  /** 0 to 1. */
  readonly amount: number;
  readonly only: true | ReadonlySet<number>;
}

/** How far an exploded model spreads at most, as a multiple of its size. */
const EXPLODE_SPREAD = 0.9;

/** The placed parts of one model as instanced bricks. */
export class ModelLayer {
  readonly group = new Group();
  readonly #library: BrickLibrary;
  readonly #materials: BrickMaterials;
  #model: Model | null = null;
  #batches: BrickBatch[] = [];
  readonly #triangles = new Map<DetailName, number>();
  #bounds: Bounds | null = null;
  #detail: DetailName = 'high';
  #scheme: ColourScheme = 'part';
  #marks: PartMarks = {};
  #isolation: Isolation | null = null;
  #display: PartDisplay = {};
  /** The model's parts where they stand now: as built, or as the display has them. */
  #parts: readonly PlacedPart[] = [];
  #explode = 0;
  #fade: Fade | null = null;

  constructor(library: BrickLibrary, materials: BrickMaterials) {
    this.#library = library;
    this.#materials = materials;
  }

  get model(): Model | null {
    return this.#model;
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

  /** Triangles of all bricks shown, at a level of detail. */
  trianglesAt(detail: DetailName): number {
    const known = this.#triangles.get(detail);
    if (known !== undefined) {
      return known;
    }
    const sum = this.#batches.reduce((total, batch) => total + batch.trianglesAt(detail), 0);
    this.#triangles.set(detail, sum);
    return sum;
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
    this.#fade = fade;
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

  /** @returns true when the level changed. */
  setDetail(detail: DetailName): boolean {
    if (detail === this.#detail) {
      return false;
    }
    this.#detail = detail;
    for (const batch of this.#batches) {
      batch.setDetail(detail);
    }
    return true;
  }

  setLinesVisible(visible: boolean): void {
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
    this.#triangles.clear();
  }

  #rebuild(): void {
    this.#clear();
    const members = new Map<string, { partId: string; style: BatchStyle; indices: number[] }>();
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
    for (const { partId, style, indices } of members.values()) {
      const content = { partId, members: indices, style, detail: this.#detail };
      const batch = new BrickBatch(this.#library, this.#materials, content);
      batch.addTo(this.group);
      this.#batches.push(batch);
    }
    this.#place();
    this.#paint();
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
      batch.place(this.#parts, (index) => this.#shift(index));
    }
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
    const parts = this.#model?.parts ?? [];
    for (const batch of this.#batches) {
      batch.paint((index) => this.#colourOf(parts[index], index));
    }
  }

  #colourOf(part: PlacedPart | undefined, index: number): number {
    if (!part) {
      return 0;
    }
    const given = this.#display.colours?.[index] ?? null;
    let hex = given ?? schemeHex(part, this.#scheme, this.#library.catalogue);
    if (this.#fade && (this.#fade.only === true || this.#fade.only.has(index))) {
      hex = mixHex(hex, this.#fade.towards, this.#fade.amount);
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
