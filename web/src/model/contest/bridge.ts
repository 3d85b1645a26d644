import {
  add,
  cross,
  dot,
  length,
  lerp,
  normalize,
  scale,
  subtract,
  type Vec3,
} from '../../geometry/vec.ts';
import type { PointLoad } from '../stress.ts';

/** A bridge contest: a truck rolls over the deck, and what holds it at the least price wins. */
export interface BridgeContest {
  /** Where the middle of the lane begins and ends, on the deck. Modules. */
  readonly deck: { readonly from: Vec3; readonly to: Vec3 };
  readonly truck: {
    /** How far each axle is behind the front one, modules, ascending from 0. */
    readonly axles: readonly number[];
    /** Weight on each axle, N. */
    readonly forces: readonly number[];
    /** Between the left and the right wheel, modules; 0: one wheel in the middle. */
    readonly track: number;
  };
  /** How far the truck rolls between two looks at it, modules. */
  readonly step: number;
  /** Least safety of all parts, all along. */
  readonly safety: number;
  /** Of parts by number; of others their mass counts. */
  readonly prices: Readonly<Record<string, number>>;
  readonly pricePerGram: number;
}

export const BRIDGE_DEFAULTS: Omit<BridgeContest, 'deck'> = Object.freeze({
  truck: { axles: [0, 6], forces: [5, 10], track: 4 },
  step: 1,
  safety: 1,
  prices: {},
  pricePerGram: 10,
});

/** What the stress model says with the truck in one place. */
export interface LoadedState {
  /** False: something moves without resistance. */
  readonly stands: boolean;
  readonly safety: number;
  /** mm */
  readonly displacement: number;
}

/** The truck with its front axle so far along the deck. */
export interface BridgePlace extends LoadedState {
  readonly front: number;
}

export interface BridgeScore {
  readonly price: number;
  /** Whether all holds wherever the truck is. */
  readonly holds: boolean;
  /** The price of a bridge that holds; null for one that does not. */
  readonly score: number | null;
  /** Where it is nearest to failing. */
  readonly worst: BridgePlace;
  readonly places: readonly BridgePlace[];
}

const UP: Vec3 = [0, 0, 1];

/** The wheels that are on the deck while the front axle is `front` modules along it. */
export function truckLoads({ deck, truck }: BridgeContest, front: number): PointLoad[] {
  const whole = length(subtract(deck.to, deck.from));
  const aside = normalize(cross(UP, subtract(deck.to, deck.from)));
  const sides = truck.track === 0 ? [0] : [-truck.track / 2, truck.track / 2];
  return truck.axles.flatMap((behind, axle) => {
    const along = front - behind;
    if (along < 0 || along > whole) {
      return [];
    }
    const middle = lerp(deck.from, deck.to, along / whole);
    const force = (truck.forces[axle] ?? 0) / sides.length;
    return sides.map((side) => ({
      at: add(middle, scale(aside, side)),
      force: [0, 0, -force] as Vec3,
    }));
  });
}

/** Where the front axle is looked at: from the deck's beginning until the last axle has left it. */
export function placesOf({ deck, truck, step }: BridgeContest): number[] {
  const last = length(subtract(deck.to, deck.from)) + Math.max(...truck.axles);
  return Array.from({ length: Math.floor(last / step + 1e-9) + 1 }, (_, i) => i * step);
}

/** What the parts cost. `massOf` in grams. */
export function priceOf(
  { prices, pricePerGram }: BridgeContest,
  parts: readonly string[],
  massOf: (part: string) => number,
): number {
  const sum = parts.reduce(
    (total, part) => total + (prices[part] ?? pricePerGram * massOf(part)),
    0,
  );
  return Math.round(sum * 100) / 100;
}

function isWorse(a: LoadedState, b: LoadedState): boolean {
  return a.stands === b.stands ? a.safety < b.safety : !a.stands;
}

/**
 * The score of a bridge. Whether it is buildable is for the checks to say.
 * @param parts numbers of its parts, each as often as it is there
 * @param stressOf the stress model, asked once for each place of the truck
 */
export function scoreBridge(
  contest: BridgeContest,
  parts: readonly string[],
  ask: {
    massOf: (part: string) => number;
    stressOf: (loads: readonly PointLoad[]) => LoadedState;
  },
): BridgeScore {
  const places = placesOf(contest).map((front) => ({
    front,
    ...ask.stressOf(truckLoads(contest, front)),
  }));
  const worst = places.reduce((a, b) => (isWorse(b, a) ? b : a));
  const holds = worst.stands && worst.safety >= contest.safety;
  const price = priceOf(contest, parts, ask.massOf);
  return { price, holds, score: holds ? price : null, worst, places };
}

/** Why a contest cannot be held; null where it can. */
export function faultOfContest(contest: BridgeContest): string | null {
  const { deck, truck, step } = contest;
  const along = subtract(deck.to, deck.from);
  if (length(along) < 1 || Math.abs(dot(normalize(along), UP)) > 0.5) {
    return 'deck: a level stretch of one module at least is needed';
  }
  if (truck.axles.length === 0 || truck.axles.length !== truck.forces.length) {
    return 'truck: as many forces as axles are needed, one at least';
  }
  if (truck.axles[0] !== 0 || truck.axles.some((x, i) => x < (truck.axles[i - 1] ?? 0))) {
    return 'truck.axles: they must ascend from 0';
  }
  return step > 0 && step <= 100 ? null : 'step: a number above 0 and up to 100 is needed';
}
