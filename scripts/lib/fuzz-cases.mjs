// Sketches and settings by a seeded generator, for `npm run fuzz`: small ones, so that many can be tried, with
// joints, pieces, symmetries, boxes that parts keep out of, a ground, and brick sets in which things are missing.
import { random, randomSketch } from './random-sketches.mjs';

const AXES = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const SLANTS = [
  [3, 4],
  [4, 3],
  [5, 12],
];
/** One in so many is of the larger kinds that `npm run random-sketches` draws. */
const LARGE_SHARE = 0.1;
const MOST_LINES = 8;
const SMALL_LINES = 4;

const add = (a, b, scale = 1) => a.map((x, i) => x + scale * b[i]);
const lengthOf = ({ from, to }) => Math.round(Math.hypot(...add(to, from, -1)));
const nodesOf = (line) => {
  const n = lengthOf(line);
  return Array.from({ length: n + 1 }, (_, k) =>
    add(line.from, add(line.to, line.from, -1), k / n),
  );
};

function step(r) {
  if (r.chance(0.85)) {
    return AXES[r.whole(0, 2)].map((x) => x * r.whole(1, 8) * r.pick([-1, 1]));
  }
  const [a, b] = r.pick(SLANTS);
  const skipped = r.whole(0, 2);
  const spans = [a * r.pick([-1, 1]), b * r.pick([-1, 1])];
  return [0, 1, 2].map((axis) => (axis === skipped ? 0 : spans.pop()));
}

/** Lines that grow from nodes of those before them. */
function grown(r, count, origin) {
  const lines = [];
  for (let i = 0; i < count; ++i) {
    const from = i === 0 ? origin : r.pick(nodesOf(r.pick(lines)));
    lines.push({ from, to: add(from, step(r)) });
  }
  return lines;
}

const isSame = (a, b) => Math.hypot(...add(a, b, -1)) < 1e-6;

/** A joint at a node where lines meet, those on one side drawn by lot; nothing where there is none. */
function joint(r, lines) {
  const at = r.pick(nodesOf(r.pick(lines)));
  const meeting = lines.flatMap((line, i) => (nodesOf(line).some((n) => isSame(n, at)) ? [i] : []));
  if (meeting.length < 2) {
    return [];
  }
  const cut = r.whole(1, meeting.length - 1);
  const between = [meeting.slice(0, cut), meeting.slice(cut)];
  return [{ at, axis: AXES[r.whole(0, 2)], between }];
}

function mirrored(lines) {
  const images = lines.map(({ from, to }) => ({
    from: [-from[0], from[1], from[2]],
    to: [-to[0], to[1], to[2]],
  }));
  return [...lines, ...images];
}

function sketchOf(r, seed, mostLines) {
  if (mostLines > SMALL_LINES && r.chance(LARGE_SHARE)) {
    return randomSketch(seed).sketch;
  }
  let lines = grown(r, r.whole(1, mostLines), [0, 0, 0]);
  if (r.chance(0.15)) {
    lines = [...lines, ...grown(r, r.whole(1, 3), [r.whole(-9, 9), r.whole(9, 15), 0])];
  }
  const sketch = { format: 'technic-sketch', version: 1, name: `fuzz ${seed}`, lines };
  if (r.chance(0.15)) {
    sketch.lines = mirrored(lines);
    sketch.symmetries = [{ kind: 'reflection', normal: [1, 0, 0], offset: 0 }];
  }
  const joints = Array.from({ length: r.chance(0.5) ? r.whole(1, 3) : 0 }, () =>
    joint(r, sketch.lines),
  ).flat();
  if (joints.length > 0) {
    sketch.joints = joints;
  }
  if (r.chance(0.15)) {
    const min = [r.whole(-4, 4), r.whole(-4, 4), r.whole(-4, 4)];
    sketch.keepOut = [{ min, max: add(min, [r.whole(0, 3), r.whole(0, 3), r.whole(0, 3)]) }];
  }
  if (r.chance(0.15)) {
    sketch.ground = Math.min(...sketch.lines.flatMap(({ from, to }) => [from[2], to[2]])) - 1;
  }
  for (const line of sketch.lines) {
    if (r.chance(0.05)) {
      line.exact = true;
    }
  }
  return sketch;
}

function keysOf(r, isSmall) {
  const efforts = isSmall ? ['0.05'] : ['0.05', '0.2', '1'];
  const keys = [`effort=${r.pick(efforts)}`, `rounds=${r.whole(0, isSmall ? 1 : 3)}`];
  const rare = (share, ...texts) => keys.push(...(r.chance(share) ? [r.pick(texts)] : []));
  rare(0.2, 'lengths=3,5,9,15', 'lengths=2,3', 'lengths=15');
  rare(0.1, 'owned.32316=1', 'owned.2780=4', 'owned.32524=0');
  rare(0.1, 'connectors=2780', 'connectors=2780,6558,3673');
  rare(0.1, 'search.axles=0', 'search.corners=0', 'search.frames=0', 'search.orbits=0');
  // To compose mechanisms of three parts takes longer than all else on a drawing of a few lines.
  rare(isSmall ? 0.9 : 0, 'mechanismParts=1', 'mechanismParts=2');
  return Object.fromEntries(keys.map((text) => text.split('=')));
}

/**
 * @param {{ isSmall?: boolean }} [options] `isSmall`: up to four lines, and the least work.
 * @returns what the seed stands for: a sketch, and settings as a session takes them.
 */
export function fuzzCase(seed, { isSmall = false } = {}) {
  const r = random(seed * 2654435761 + 1);
  const sketch = sketchOf(r, seed, isSmall ? SMALL_LINES : MOST_LINES);
  const slow = isSmall ? 0.4 : 1; // what takes many times as long is rarer where many are to be tried
  const preset = r.chance(0.25 * slow) ? 'simple-rigid' : r.pick(['simple', 'simple', 'faithful']);
  const method = r.chance(0.05 * slow) ? { method: 'paper' } : {};
  return { sketch, settings: { preset, ...method, set: keysOf(r, isSmall) } };
}

/** Settings as options of the command. */
export function argumentsOf({ preset, method, set }) {
  const pairs = Object.entries(set).flatMap(([key, value]) => ['--set', `${key}=${value}`]);
  return [...pairs, '--preset', preset, ...(method === undefined ? [] : ['--method', method])];
}

const times = (m, n) =>
  [0, 1, 2].flatMap((i) =>
    [0, 1, 2].map((k) => m[3 * i] * n[k] + m[3 * i + 1] * n[3 + k] + m[3 * i + 2] * n[6 + k]),
  );

/** Axes about which the sketch may stand at any angle: no line leaves its plane, and nothing else names an axis. */
function freeAxes({ lines, keepOut, ground }) {
  if (keepOut || ground !== undefined || lines.some(({ holeAxis }) => holeAxis)) {
    return [];
  }
  const isFlat = ({ from, to }, k) => {
    const span = add(to, from, -1);
    const along = Math.abs(span[k]);
    return along < 1e-6 || Math.hypot(...span) - along < 1e-6;
  };
  return [0, 1, 2].filter((k) => lines.every((line) => isFlat(line, k)));
}

function turnAbout(k, angle) {
  const [i, j] = [(k + 1) % 3, (k + 2) % 3];
  const m = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  m[3 * i + i] = m[3 * j + j] = Math.cos(angle);
  m[3 * j + i] = Math.sin(angle);
  m[3 * i + j] = -Math.sin(angle);
  return m;
}

/**
 * A proper turn about the upright axis or, where nothing is said of up, any of the lattice, half of the time after
 * one by any angle where the sketch stays legal; then a shift.
 */
export function rigidMotion(seed, sketch) {
  const r = random(seed * 40503 + 7);
  const shift = [0, 1, 2].map(
    () => r.whole(-50, 50) + (sketch.keepOut ? 0 : r.pick([0, 0, 1 / 3])),
  );
  if (sketch.ground !== undefined) {
    const turns = [
      [1, 0, 0, 0, 1, 0, 0, 0, 1],
      [0, -1, 0, 1, 0, 0, 0, 0, 1],
      [-1, 0, 0, 0, -1, 0, 0, 0, 1],
    ];
    return { turn: r.pick(turns), shift };
  }
  const order = r.pick([
    [0, 1, 2],
    [1, 2, 0],
    [2, 0, 1],
  ]);
  const signs = r.pick([
    [1, 1, 1],
    [1, -1, -1],
    [-1, 1, -1],
    [-1, -1, 1],
  ]);
  const turn = [0, 1, 2].flatMap((i) => [0, 1, 2].map((k) => (order[i] === k ? signs[i] : 0)));
  const axes = freeAxes(sketch);
  if (axes.length === 0 || r.chance(0.5)) {
    return { turn, shift };
  }
  // Not within 4 degrees of the lattice: reading straightens lines that lean by less than its tolerance.
  const angle = ((90 * r.whole(0, 3) + r.whole(4, 86)) * Math.PI) / 180;
  return { turn: times(turn, turnAbout(r.pick(axes), angle)), shift };
}
