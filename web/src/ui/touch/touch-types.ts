import type { Place } from '../../model/keep.ts';

/** What else could lie where a part does; whether it makes a model, a search says. */
export interface Fits {
  readonly fits: readonly Place[];
  /** The part itself on its other layers. */
  readonly layers: readonly Place[];
}

/** What another part in place of one makes of the model. */
export interface Trial {
  readonly place: Place;
  /** More of these than now; null where no model was found. */
  readonly change: {
    readonly bricks: number;
    readonly beams: number;
    readonly freedoms: number;
  } | null;
}
