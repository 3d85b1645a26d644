import type { Vec3 } from '../geometry/vec.ts';

/** One thing that is wrong, and where. */
export interface Problem {
  readonly kind: string;
  readonly message: string;
  readonly at?: Vec3;
  /** Indices into the model's parts. */
  readonly parts?: readonly number[];
  /** Of kind `keep`: the line on which what is kept cannot be. */
  readonly line?: number;
}

/** A straight piece of the sketch, modules. */
export interface Stretch {
  readonly from: Vec3;
  readonly to: Vec3;
}

/** The report of a solve (DESIGN 4). Keys that a run does not fill are left out. */
export interface Report {
  readonly name?: string;
  readonly seed?: number;
  readonly preset?: string;
  readonly method?: string;
  readonly lines?: number;
  /** Sum of the line lengths, modules. */
  readonly length?: number;
  /** Parts of the sketch that do not touch each other. */
  readonly pieces?: number;
  readonly components?: number;
  readonly beams?: number;
  readonly bricks?: number;
  /** Lines, or straight chains of them, that an axle covers instead of beams. */
  readonly axles?: number;
  /** Empty layers in stacks that nothing fills, and those that spacers fill. */
  readonly gaps?: number;
  readonly filledGaps?: number;
  readonly collisions?: number;
  readonly uncovered?: number;
  readonly failedConnections?: number;
  readonly pinHeadRatio?: number;
  /** Parts in another colour than the catalogue knows them in. */
  readonly unusualColours?: number;
  /** Mean distance of beams from their lines, modules. */
  readonly deviation?: number;
  readonly layerRange?: number;
  readonly symmetryDeviation?: number;
  /** Stretches whose beams differ from their images, though the sketch's symmetries ask for the same. */
  readonly asymmetric?: readonly Stretch[];
  readonly rigidSubsets?: number;
  /** Internal degrees of freedom. */
  readonly freedoms?: number;
  readonly balanced?: boolean;
  readonly assemblable?: boolean;
  /** Whether it went on from the model of an earlier sketch: a link gives another one. */
  readonly grown?: boolean;
  readonly buildable?: boolean;
  readonly wellBuilt?: WellBuilt;
  readonly problems?: readonly Problem[];
  readonly objective?: number;
  readonly iterations?: number;
  readonly seconds?: {
    readonly stageOne: number;
    readonly stageTwo: number;
    readonly total: number;
  };
  readonly beamsLowerBound?: number;
  /** Grams. */
  readonly mass?: number;
  /** Extent in modules along x, y and z. */
  readonly size?: Vec3;
}

/** One line of the check of a model (DESIGN 5). */
export interface CheckItem {
  readonly id: string;
  readonly title: string;
  readonly ok: boolean;
  readonly detail: string;
}

/** One item of what a builder expects beyond that (DESIGN 5b). */
export interface WellBuiltItem extends CheckItem {
  /** False where the drawing asks for nothing of the kind; then `ok` holds. */
  readonly applies: boolean;
  readonly figures: Readonly<Record<string, number>>;
  /** Where it falls short. */
  readonly places: readonly Problem[];
}

/** How well a model is built. */
export interface WellBuilt {
  readonly passed: number;
  readonly of: number;
  readonly items: readonly WellBuiltItem[];
}

/** What the check of a model file answers. */
export interface CheckReport {
  readonly buildable: boolean;
  readonly items: readonly CheckItem[];
  readonly problems: readonly Problem[];
  readonly wellBuilt: WellBuilt;
}
