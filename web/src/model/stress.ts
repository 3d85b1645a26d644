import type { Vec3 } from '../geometry/vec.ts';
import { mixHex } from './colours.ts';

/** What of the fits friction is taken to hold (core/analysis/frame_model.h). */
export type FitHold = 'free' | 'held' | 'locked';

/** A force in one point: modules and newtons. */
export interface PointLoad {
  readonly at: Vec3;
  readonly force: Vec3;
}

export interface StressOptions {
  readonly friction: FitHold;
  readonly loads: readonly PointLoad[];
}

/** Place (modules), von Mises stress (MPa) and displacement (mm): x, y, z, stress, dx, dy, dz. */
export type StressSample = readonly [number, number, number, number, number, number, number];

export interface PartStress {
  /** Greatest von Mises stress, MPa. */
  readonly stress: number;
  readonly safety: number;
  /** Stress over yield stress. */
  readonly utilisation: number;
}

export interface StressResult {
  readonly ok: true;
  /** That it rests otherwise than drawn; else empty. */
  readonly message: string;
  readonly maxStress: number;
  readonly safety: number;
  /** mm */
  readonly maxDisplacement: number;
  /** N */
  readonly weight: number;
  /** Degrees. */
  readonly tilt: number;
  readonly parts: readonly PartStress[];
  /** By part: three for each bar of it, at its ends and in its middle. */
  readonly samples: readonly (readonly StressSample[])[];
  readonly pins: readonly {
    readonly part: number;
    /** MPa */
    readonly shear: number;
    readonly safety: number;
    /** N mm */
    readonly torque: number;
  }[];
  readonly reactions: readonly PointLoad[];
}

/** Something moves without resistance. */
export interface StressRefusal {
  readonly ok: false;
  readonly message: string;
  readonly moving: readonly number[];
}

export type StressAnswer = StressResult | StressRefusal;

/** The text is our own module's: tests/contract checks its fields. */
export function readStressAnswer(text: string): StressAnswer {
  return JSON.parse(text) as StressAnswer;
}

/** Colours from no stress to the greatest, sRGB; they differ in lightness too. */
export const STRESS_RAMP = [0x2b5fb8, 0x2fa39a, 0x9cc73c, 0xf2b21d, 0xc9302c] as const;

/** Colour of a share of the greatest stress. @param share 0 to 1; what is outside is cut off. */
export function stressHex(share: number): number {
  const last = STRESS_RAMP.length - 1;
  const at = Math.min(1, Math.max(0, Number.isFinite(share) ? share : 0)) * last;
  const step = Math.min(last - 1, Math.floor(at));
  return mixHex(STRESS_RAMP[step] ?? 0, STRESS_RAMP[step + 1] ?? 0, at - step);
}

/** Colours of all parts by their greatest stress. */
export function stressColours(result: StressResult): number[] {
  return result.parts.map((part) => stressHex(part.stress / (result.maxStress || 1)));
}

const MM_PER_MODULE = 8;

/** Where a sample is with its displacement exaggerated, modules. */
export function displacedPoint(sample: StressSample, exaggeration: number): Vec3 {
  const factor = exaggeration / MM_PER_MODULE;
  const [x, y, z, , dx, dy, dz] = sample;
  return [x + factor * dx, y + factor * dy, z + factor * dz];
}

/** The exaggeration that shows the greatest displacement as one and a half modules. */
export function fullExaggeration(result: StressResult): number {
  const shown = 1.5 * MM_PER_MODULE;
  return result.maxDisplacement > 0 ? shown / result.maxDisplacement : 1;
}
