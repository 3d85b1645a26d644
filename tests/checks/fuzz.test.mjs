import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { test } from 'vitest';
import { argumentsOf, fuzzCase, rigidMotion } from '../../scripts/lib/fuzz-cases.mjs';
import { movedModel } from '../../scripts/lib/fuzz-motion.mjs';
import { looksAlike, outlineOf } from '../../scripts/lib/fuzz-round-trips.mjs';
import { TOP } from '../../scripts/lib/run.mjs';

const apart = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));

test('a seed stands for one case', () => {
  assert.deepEqual(fuzzCase(17), fuzzCase(17));
  assert.notDeepEqual(fuzzCase(17), fuzzCase(18));
});

test('cases have lines of whole lengths, and some of each annotation', () => {
  const cases = Array.from({ length: 300 }, (_, i) => fuzzCase(i + 1));
  for (const { sketch } of cases.filter(({ sketch }) => sketch.name.startsWith('fuzz'))) {
    for (const { from, to } of sketch.lines) {
      const length = apart(from, to);
      assert.ok(Math.abs(length - Math.round(length)) < 1e-9 && length > 0.5, sketch.name);
    }
  }
  for (const key of ['joints', 'symmetries', 'keepOut', 'ground']) {
    assert.ok(cases.filter(({ sketch }) => key in sketch).length > 10, key);
  }
});

test('a moved model keeps its distances and its handedness', () => {
  const sketch = { lines: [{ from: [0, 0, 0], to: [4, 0, 0], holeAxis: 'y' }] };
  const rotation = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  const parts = [
    { part: '32316', position: [0, 0, 0], rotation, layer: 1 },
    { part: '2780', position: [1, 2, 3], rotation, layer: 0 },
  ];
  for (let seed = 1; seed <= 50; ++seed) {
    const moved = movedModel({ parts, sketch }, rigidMotion(seed, sketch));
    const [a, b] = moved.parts.map(({ position }) => position);
    assert.ok(Math.abs(apart(a, b) - Math.sqrt(14)) < 1e-8);
    const [x, y, z, p, q, r, u, v, w] = moved.parts[0].rotation;
    assert.equal(x * (q * w - r * v) - y * (p * w - r * u) + z * (p * v - q * u), 1);
    const [line] = moved.sketch.lines;
    const along = line.to.map((value, i) => value - line.from[i]);
    assert.ok(Math.abs(along['xyz'.indexOf(line.holeAxis)]) < 1e-8);
  }
});

test('small cases have four lines and their images, and three more apart, at most', () => {
  for (let seed = 1; seed <= 200; ++seed) {
    const { sketch, settings } = fuzzCase(seed, { isSmall: true });
    assert.ok(sketch.lines.length <= 2 * (4 + 3), sketch.name);
    assert.equal(settings.set.effort, '0.05');
  }
});

test('settings are said to the command as to the module', () => {
  const settings = { preset: 'simple', method: 'paper', set: { effort: '1', 'owned.2780': '4' } };
  assert.deepEqual(argumentsOf(settings), [
    ...['--set', 'effort=1', '--set', 'owned.2780=4'],
    ...['--preset', 'simple', '--method', 'paper'],
  ]);
});

test('a beam looks alike after half a turn, and no other way; a cross block after none', () => {
  const file = readFileSync(resolve(TOP, 'core/parts/catalogue.json'), 'utf8');
  const outline = (id) => outlineOf(JSON.parse(file).parts.find((part) => part.id === id));
  const upright = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  const half = [-1, 0, 0, 0, -1, 0, 0, 0, 1];
  const quarter = [0, -1, 0, 1, 0, 0, 0, 0, 1];
  assert.ok(looksAlike(outline('32525'), upright, half));
  assert.ok(!looksAlike(outline('32525'), upright, quarter));
  const overX = [1, 0, 0, 0, -1, 0, 0, 0, -1];
  assert.ok(!looksAlike(outline('6536'), upright, overX));
});
