import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { expect, test } from 'vitest';
import {
  dataset,
  FAMILIES,
  familySketch,
  gridSketch,
  SIZES,
  scaled,
} from '../../scripts/lib/families/families.mjs';
import { FAULTS } from '../../scripts/lib/families/faults.mjs';
import { random } from '../../scripts/lib/random-sketches.mjs';

const lengthOf = ({ from, to }) => Math.hypot(...from.map((x, i) => to[i] - x));

test('every line of a thousand sketches has a whole number of modules, one at least', () => {
  for (const { name, sketch } of dataset(1000)) {
    for (const line of sketch.lines) {
      const length = lengthOf(line);
      expect(Math.abs(length - Math.round(length)), name).toBeLessThan(0.01);
      expect(length, name).toBeGreaterThan(0.9);
    }
  }
});

test('a thousand sketches have names of their own, and those of all families', () => {
  const names = dataset(1000).map(({ name }) => name);
  expect(new Set(names).size).toBe(1000);
  for (const family of Object.keys(FAMILIES)) {
    expect(names).toContain(`${family}-4-1`);
  }
});

test('a name is always the same sketch', () => {
  expect(familySketch('tree', 3, 5)).toEqual(familySketch('tree', 3, 5));
  expect(familySketch('tree', 3, 5)).not.toEqual(familySketch('tree', 3, 6));
});

test('no sketch draws a line twice', () => {
  for (const { name, sketch } of dataset(200)) {
    const keys = sketch.lines.map(({ from, to }) => [from.join(), to.join()].sort().join(' '));
    expect(new Set(keys).size, name).toBe(keys.length);
  }
});

test('larger sizes have more line', () => {
  for (const family of Object.keys(FAMILIES)) {
    const total = (size) =>
      familySketch(family, size, 1).sketch.lines.reduce((sum, line) => sum + lengthOf(line), 0);
    expect(total(SIZES.at(-1)), family).toBeGreaterThan(total(SIZES[0]));
  }
});

test('joints of linkages are where their lines meet', () => {
  const { lines, joints } = familySketch('linkage', 3, 2).sketch;
  for (const { at, between } of joints) {
    for (const line of between.flat()) {
      expect([lines[line].from, lines[line].to]).toContainEqual(at);
    }
  }
});

test('a grid of n has n + 1 lines each way, and twice as long is twice as long', () => {
  const grid = gridSketch(5);
  expect(grid.lines.length).toBe(12);
  expect(lengthOf(scaled(grid, 2).lines[0])).toBe(2 * lengthOf(grid.lines[0]));
});

test('a fault changes the model, and nothing in the model that it was given', () => {
  const file = resolve(import.meta.dirname, '../../public/examples/cube.sketch.json');
  const sketch = JSON.parse(readFileSync(file, 'utf8'));
  const part = (x) => ({
    part: '32316',
    position: [x, 0, 0],
    rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  });
  const model = { parts: [part(0), part(5)], sketch };
  const before = JSON.stringify(model);
  for (const [kind, plant] of Object.entries(FAULTS)) {
    expect(JSON.stringify(plant(model, random(3))), kind).not.toBe(before);
  }
  expect(JSON.stringify(model)).toBe(before);
});
