import assert from 'node:assert/strict';
import { test } from 'vitest';
import { fuzzCase, rigidMotion } from '../../scripts/lib/fuzz-cases.mjs';
import { movedModel } from '../../scripts/lib/fuzz-motion.mjs';

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
