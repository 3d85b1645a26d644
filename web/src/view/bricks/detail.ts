/** How finely parts are drawn. */
export type DetailName = 'ultra' | 'high' | 'medium' | 'low';

/** What a level of detail draws. */
export interface Detail {
  readonly name: DetailName;
  /** Sides of a full circle of beam size; a multiple of 4. */
  readonly segments: number;
  /** Width of the rounding along a beam's rims, modules; 0 for none. */
  readonly rounding: number;
  /** The wide rings at both ends of a hole. */
  readonly counterbores: boolean;
  /** Slots, lips and ridges of pins. */
  readonly pinDetails: boolean;
  /** Lines on smooth surfaces where they turn away from the eye. */
  readonly silhouettes: boolean;
}

export const DETAILS: Readonly<Record<DetailName, Detail>> = {
  ultra: {
    name: 'ultra',
    segments: 48,
    rounding: 0.025,
    counterbores: true,
    pinDetails: true,
    silhouettes: true,
  },
  high: {
    name: 'high',
    segments: 24,
    rounding: 0.025,
    counterbores: true,
    pinDetails: true,
    silhouettes: true,
  },
  medium: {
    name: 'medium',
    segments: 12,
    rounding: 0,
    counterbores: true,
    pinDetails: false,
    silhouettes: true,
  },
  low: {
    name: 'low',
    segments: 8,
    rounding: 0,
    counterbores: false,
    pinDetails: false,
    silhouettes: false,
  },
};

/** Shapes that all Technic parts share, in modules (8 mm). */
export const DIMENSIONS = {
  /** Half the width of a beam, and the radius of its ends. */
  bodyRadius: 0.45,
  holeRadius: 0.305,
  counterboreRadius: 0.4,
  counterboreDepth: 0.1,
  /** A little under the hole's, so that the two surfaces never fight for a pixel. */
  pinRadius: 0.292,
  pinLipRadius: 0.32,
  pinBoreRadius: 0.2,
  collarRadius: 0.4,
  collarWidth: 0.1,
  axleRadius: 0.3,
  /** Half the width of a wing of an axle's cross. */
  axleWing: 0.105,
  axleHoleRadius: 0.312,
  axleHoleWing: 0.12,
} as const;
