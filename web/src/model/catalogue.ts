import type { Vec3 } from '../geometry/vec.ts';
import type { GuestKind } from './guests.ts';

/** Mirrors parts::PartClass in core/parts/catalogue.h. */
export type PartClass = 'beam' | 'pin' | 'axle' | 'connector' | 'bush' | 'gear';

/** A male pin or axle, or a female pin or axle hole. */
export type FeatureKind = 'pin' | 'axle' | 'pinHole' | 'axleHole';

/** A hole or a head: a straight stretch along an axis. Part frame, modules. */
export interface Feature {
  readonly kind: FeatureKind;
  /** Middle of the stretch. */
  readonly center: Vec3;
  /** Unit vector along the stretch. */
  readonly axis: Vec3;
  readonly length: number;
  /** Direction of one wing of an axle's cross. */
  readonly wing?: Vec3;
  /** Slot middles, one module apart. */
  readonly slots: readonly Vec3[];
}

/** One stretch of a beam that covers sketch edges: from its first to its last hole centre. */
export interface Stretch {
  readonly from: Vec3;
  readonly to: Vec3;
}

/** All points within `radius` (across) of the segment and `halfThickness` along `axis`. */
export interface Prism {
  readonly from: Vec3;
  readonly to: Vec3;
  readonly axis: Vec3;
  readonly radius: number;
  readonly halfThickness: number;
}

/** One real part; its frame is LDraw's own, turned so that Z is up and 1 is a module. */
export interface Part {
  readonly id: string;
  readonly name: string;
  readonly partClass: PartClass;
  /** Grams. */
  readonly mass: number;
  readonly massEstimated: boolean;
  /** A pin that holds by friction. */
  readonly friction: boolean;
  /** Default LDraw colour. */
  readonly color: number;
  /** Straight beams: number of holes; others 0. */
  readonly holes: number;
  /** Beams: 1 or 0.5 modules. */
  readonly thickness: number;
  readonly features: readonly Feature[];
  readonly stretches: readonly Stretch[];
  /** Body only, without the heads of `features`. */
  readonly solid: readonly Prism[];
  /** Wide rings on pins and axles: they fill the counterbore of the hole next to them. */
  readonly collars: readonly Prism[];
  readonly boundsMin: Vec3;
  readonly boundsMax: Vec3;
  /** Only of a part that a file of others holds and that is not judged; see guests.ts. */
  readonly guest?: GuestKind;
}

/** All parts that may be used, by their number. */
export class Catalogue {
  readonly parts: readonly Part[];
  readonly #byId: ReadonlyMap<string, Part>;
  #guests: ReadonlyMap<string, Part> = new Map();

  constructor(parts: readonly Part[]) {
    this.parts = parts;
    this.#byId = new Map(parts.map((part) => [part.id, part]));
  }

  /** The parts of the model on screen that are none of these: find() knows them until others come. */
  welcome(guests: readonly Part[]): void {
    this.#guests = new Map(guests.map((part) => [part.id, part]));
  }

  /** The part with this LDraw number, or undefined. */
  find(id: string): Part | undefined {
    return this.#byId.get(id) ?? this.#guests.get(id);
  }
}

/** The catalogue as core/parts/catalogue.json holds it. */
export interface CatalogueFile {
  readonly format: string;
  readonly version: number;
  readonly parts: readonly CatalogueEntry[];
}

/** One part as the file holds it: `class` for partClass, `bounds` for both corners. */
interface CatalogueEntry extends Omit<Part, 'partClass' | 'boundsMin' | 'boundsMax'> {
  readonly class: PartClass;
  readonly bounds: { readonly min: Vec3; readonly max: Vec3 };
}

/**
 * The catalogue from its file.
 * @throws Error when the text is not a catalogue: it is our own data, so that is a broken build.
 */
export function readCatalogue(file: unknown): Catalogue {
  if (!isCatalogueFile(file)) {
    throw new Error('The part catalogue is not in its expected form.');
  }
  return new Catalogue(
    file.parts.map(({ class: partClass, bounds, ...rest }) => ({
      ...rest,
      partClass,
      boundsMin: bounds.min,
      boundsMax: bounds.max,
    })),
  );
}

function isCatalogueFile(file: unknown): file is CatalogueFile {
  return (
    typeof file === 'object' &&
    file !== null &&
    'format' in file &&
    file.format === 'liftarm-catalogue' &&
    'parts' in file &&
    Array.isArray(file.parts)
  );
}

export function isMale(kind: FeatureKind): boolean {
  return kind === 'pin' || kind === 'axle';
}

export function isHole(kind: FeatureKind): boolean {
  return kind === 'pinHole' || kind === 'axleHole';
}
