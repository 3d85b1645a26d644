import type { Mat3, Vec3 } from '../geometry/vec.ts';
import type { GuestKind } from './guests.ts';
import type { SketchDocument } from './sketch.ts';

/** One real part in its place; mirrors core/model/model.h. */
export interface PlacedPart {
  /** Catalogue id, an LDraw part number. */
  readonly part: string;
  /** LDraw colour code. */
  readonly color: number;
  /** Where the part's origin lies, modules. */
  readonly position: Vec3;
  /** Part frame to world, row-major. */
  readonly rotation: Mat3;
  /** Beams: index of the coplanar component, else -1. */
  readonly component: number;
  /** Beams: offset along the hole axis. */
  readonly layer: number;
  /** Connected part of the sketch. */
  readonly piece: number;
}

/** A model file: placed parts and the sketch that they were made for. */
export interface Model {
  readonly format?: string;
  readonly version?: number;
  readonly name: string;
  readonly parts: readonly PlacedPart[];
  readonly sketch?: SketchDocument | null;
  /** The last `count` parts are none of the catalogue; see guests.ts. */
  readonly guests?: { readonly count: number; readonly kinds: readonly GuestKind[] };
}
