import { expect, it } from 'vitest';
import {
  ASSEMBLIES,
  blockerOf,
  DIRECTIONS,
  type Direction,
} from '../../../web/src/ui/lessons/take-apart.ts';

const WAYS = Object.keys(DIRECTIONS) as Direction[];

/** Takes off whatever is free, groups of up to `size`. @returns how many parts are left. */
function takeApart(level: number, size: number): number {
  const parts = ASSEMBLIES[level] ?? [];
  const present = new Set(parts.keys());
  const groups = [...parts.keys()].flatMap((a) =>
    size === 1 ? [[a]] : [[a], ...[...parts.keys()].filter((b) => b > a).map((b) => [a, b])],
  );
  for (let moved = true; moved; ) {
    moved = false;
    for (const group of groups) {
      const whole = group.every((index) => present.has(index)) && group.length < present.size;
      const free = WAYS.some((way) => blockerOf(parts, present, new Set(group), way) < 0);
      if (whole && free) {
        for (const index of group) {
          present.delete(index);
        }
        moved = true;
      }
    }
  }
  return present.size;
}

it('the first assembly comes apart one by one', () => {
  expect(takeApart(0, 1)).toBe(1);
});

it('the second needs two parts moved together', () => {
  expect(takeApart(1, 1)).toBe(3);
  expect(takeApart(1, 2)).toBe(1);
});

it('parts never overlap', () => {
  for (const parts of ASSEMBLIES) {
    const cells = parts.flat().map(({ x, y }) => `${x},${y}`);
    expect(new Set(cells).size).toBe(cells.length);
  }
});
