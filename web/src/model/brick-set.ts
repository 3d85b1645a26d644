/**
 * The parts that the search builds with, and how a person's choice among them is said to it. Mirrors
 * the defaults of core/design/settings.h; tests/contract/contract.test.ts compares them.
 */

/** Straight beams by their number of holes; 4 and 6 are two thin ones. */
const BEAMS: readonly (readonly [number, string])[] = [
  [2, '43857'],
  [3, '32523'],
  [5, '32316'],
  [6, '32063'],
  [7, '32524'],
  [9, '40490'],
  [11, '32525'],
  [13, '41239'],
  [15, '32278'],
];

/** L and T beams, and those bent by 53.13 degrees. */
const BENT: readonly string[] = ['32140', '32271', '32348', '32526', '60484', '6629'];

/** Beams of several bars: an H and two with an open middle. */
const FRAMES: readonly string[] = ['14720', '64178', '64179'];

/** Pins and what is joined with them; 18654 fills gaps in stacks. */
const CONNECTORS: readonly string[] = [
  '2780',
  '6558',
  '87082',
  '48989',
  '55615',
  '15462',
  '3713',
  '18654',
  '15100',
  '44809',
];

/** Axles that cover lines, by length; 15462 joins stacks as well. */
const AXLES: readonly string[] = [
  '4519',
  '24316',
  '3705',
  '87083',
  '32073',
  '15462',
  '3706',
  '44294',
  '3707',
  '55013',
  '60485',
  '3737',
  '23948',
  '3708',
];

/** Parts that cannot be switched off: joints in line are pinned with them. */
export const NEEDED_PARTS: ReadonlySet<string> = new Set(['2780']);

/** All parts that can be switched, beams first, in the order in which they are shown. */
export const SET_PARTS: readonly string[] = [
  ...BEAMS.map(([, id]) => id),
  ...BENT,
  ...FRAMES,
  ...CONNECTORS,
  ...AXLES.filter((id) => !CONNECTORS.includes(id)),
];

/** The settings of the search for a brick set; none for the whole one. */
export function brickSetSettings(off: ReadonlySet<string>): Readonly<Record<string, string>> {
  const lengths = BEAMS.filter(([, id]) => !off.has(id)).map(([length]) => length);
  const bent = BENT.filter((id) => !off.has(id));
  const frames = FRAMES.filter((id) => !off.has(id));
  const axles = AXLES.filter((id) => !off.has(id));
  const connectors = CONNECTORS.filter((id) => NEEDED_PARTS.has(id) || !off.has(id));
  return {
    ...(lengths.length < BEAMS.length && lengths.length > 0 ? { lengths: lengths.join() } : {}),
    ...(bent.length < BENT.length ? { bent: bent.join() } : {}),
    ...(frames.length < FRAMES.length ? { frames: frames.join() } : {}),
    ...(axles.length < AXLES.length ? { axles: axles.join() } : {}),
    ...(connectors.length < CONNECTORS.length ? { connectors: connectors.join() } : {}),
  };
}

/** Parts that a model needs beyond what is owned, by part number. Parts not counted are enough. */
export function shortages(
  needed: Iterable<{ readonly part: string; readonly count: number }>,
  owned: Readonly<Record<string, number>>,
): ReadonlyMap<string, number> {
  const sums = new Map<string, number>();
  for (const { part, count } of needed) {
    sums.set(part, (sums.get(part) ?? 0) + count);
  }
  const short = new Map<string, number>();
  for (const [part, count] of sums) {
    const have = owned[part];
    if (have !== undefined && have < count) {
      short.set(part, count - have);
    }
  }
  return short;
}
