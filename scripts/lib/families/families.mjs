// Families of sketches for measuring: furniture, vehicles, towers, bridges, linkages, letters, polycubes, lattices
// and trees, each in sizes 1 to 4 and any number of variants. A name is always the same sketch, on any machine: whole
// numbers, a seeded generator, square roots, and nothing else.
import { random } from '../random-sketches.mjs';
import { add, box, grid, line, loop, path, posts, rectangle, truss, unique } from './shapes.mjs';

const AXES = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

function table(r, size) {
  const [w, d, h] = [r.whole(4, 7) + 2 * size, r.whole(3, 5) + 2 * size, r.whole(4, 6) + size];
  const lines = [...posts([0, 0, 0], [w, d, h]), ...rectangle([0, 0, h], [w, d])];
  for (let i = 1; i < size; ++i) {
    const z = h - 2 * i;
    if (z > 1) {
      lines.push(line([0, 0, z], [0, d, z]), line([w, 0, z], [w, d, z]));
    }
  }
  return lines;
}

function chair(r, size) {
  const [w, d, h] = [r.whole(4, 6) + size, r.whole(4, 6) + size, r.whole(4, 6) + size];
  const back = h + r.whole(4, 6) + size;
  const lines = [...posts([0, 0, 0], [w, d, h]), ...rectangle([0, 0, h], [w, d])];
  lines.push(...path([0, d, h], [0, d, back], [w, d, back], [w, d, h]));
  for (let i = 1; i < size; ++i) {
    const z = back - 2 * i;
    if (z > h + 1) {
      lines.push(line([0, d, z], [w, d, z]));
    }
  }
  return lines;
}

function shelf(r, size) {
  const [w, d, h] = [r.whole(4, 8), r.whole(3, 6), r.whole(4, 6)];
  const lines = [];
  for (let k = 0; k < size; ++k) {
    for (let i = 0; i < Math.ceil(size / 2); ++i) {
      lines.push(...box([i * w, 0, k * h], [w, d, h]));
    }
  }
  return lines;
}

function vehicle(r, size) {
  const [length, width] = [2 * r.whole(5, 7) + 4 * size, 2 * r.whole(2, 3) + 2 * size];
  const [cab, height] = [r.whole(4, 6), r.whole(3, 5) + size];
  const lines = [...rectangle([0, 0, 2], [length, width])];
  for (let axle = 2; axle < length; axle += Math.floor(length / (size + 1))) {
    lines.push(line([axle, 0, 0], [axle, 0, 2]), line([axle, width, 0], [axle, width, 2]));
    lines.push(line([axle, 0, 2], [axle, width, 2]));
  }
  lines.push(...posts([0, 0, 2], [cab, width, height]));
  lines.push(...rectangle([0, 0, 2 + height], [cab, width]));
  lines.push(line([cab, 0, 2], [cab, width, 2]));
  return lines;
}

function tower(r, size) {
  const [w, h] = r.pick([
    [8, 6],
    [6, 8],
  ]);
  const lines = [];
  for (let k = 0; k < size; ++k) {
    lines.push(...box([0, 0, k * h], [w, w, h]));
    for (const y of [0, w]) {
      if (r.chance(0.7)) {
        lines.push(line([0, y, k * h], [w, y, (k + 1) * h]));
      }
    }
  }
  lines.push(...posts([0, 0, size * h], [w, w, r.whole(2, 4)]));
  return lines;
}

function bridge(r, size) {
  const scale = r.pick([1, 2]);
  const [bays, width] = [2 * size, r.whole(4, 8)];
  const lines = [...truss(0, bays, scale), ...truss(width, bays, scale)];
  for (let i = 0; i <= bays; ++i) {
    lines.push(line([4 * scale * i, 0, 0], [4 * scale * i, width, 0]));
  }
  return lines;
}

/** Parallelograms in a row that share their bars: each turns at every corner. */
function linkage(r, size) {
  const [w, h] = [r.whole(4, 8), r.whole(4, 7)];
  const lines = [];
  const joints = [];
  const bars = size + 1;
  for (let i = 0; i < size; ++i) {
    lines.push(line([i * w, 0, 0], [(i + 1) * w, 0, 0]), line([i * w, 0, h], [(i + 1) * w, 0, h]));
  }
  for (let i = 0; i < bars; ++i) {
    lines.push(line([i * w, 0, 0], [i * w, 0, h]));
    const post = 2 * size + i;
    for (const [z, offset] of [
      [0, 0],
      [h, 1],
    ]) {
      const met = [i - 1, i].filter((k) => k >= 0 && k < size).map((k) => 2 * k + offset);
      joints.push({ at: [i * w, 0, z], axis: [0, 1, 0], between: [met, [post]] });
    }
  }
  return { lines, joints };
}

const STROKES = {
  E: [path([4, 0, 0], [0, 0, 0], [0, 0, 8], [4, 0, 8]), path([0, 0, 4], [3, 0, 4])],
  F: [path([0, 0, 0], [0, 0, 8], [4, 0, 8]), path([0, 0, 4], [3, 0, 4])],
  H: [path([0, 0, 0], [0, 0, 8]), path([4, 0, 0], [4, 0, 8]), path([0, 0, 4], [4, 0, 4])],
  I: [path([0, 0, 0], [0, 0, 8])],
  L: [path([0, 0, 8], [0, 0, 0], [4, 0, 0])],
  N: [path([0, 0, 0], [0, 0, 8], [6, 0, 0], [6, 0, 8])],
  O: [loop([0, 0, 0], [4, 0, 0], [4, 0, 8], [0, 0, 8])],
  T: [path([0, 0, 8], [6, 0, 8]), path([3, 0, 0], [3, 0, 8])],
  U: [path([0, 0, 8], [0, 0, 0], [4, 0, 0], [4, 0, 8])],
  Z: [path([0, 0, 8], [6, 0, 8], [0, 0, 0], [6, 0, 0])],
};

/** Letters side by side on a bar that joins their feet. */
function letters(r, size) {
  const lines = [];
  for (let i = 0; i <= size; ++i) {
    for (const stroke of STROKES[r.pick(Object.keys(STROKES))]) {
      lines.push(...stroke.map(([from, to]) => [add(from, [9 * i, 0, 2]), add(to, [9 * i, 0, 2])]));
    }
    lines.push(line([9 * i, 0, 0], [9 * i, 0, 2]));
  }
  lines.push(line([0, 0, 0], [9 * size, 0, 0]));
  return lines;
}

/** Cubes that grow face to face. */
function polycube(r, size) {
  const side = r.whole(3, 6);
  const cells = [[0, 0, 0]];
  while (cells.length < size + 1) {
    const next = add(
      r.pick(cells),
      r.pick(AXES).map((x) => x * r.pick([1, -1])),
    );
    if (!cells.some((cell) => cell.join() === next.join())) {
      cells.push(next);
    }
  }
  return cells.flatMap((cell) =>
    box(
      cell.map((x) => x * side),
      [side, side, side],
    ),
  );
}

function lattice(r, size) {
  const cell = r.whole(3, 6);
  const levels = r.whole(1, 2);
  const lines = [];
  for (let z = 0; z < levels; ++z) {
    lines.push(...grid([0, 0, z * cell], [size + 1, size], cell));
  }
  for (let i = 0; i <= size + 1 && levels > 1; ++i) {
    for (const j of [0, size]) {
      lines.push(line([i * cell, j * cell, 0], [i * cell, j * cell, cell]));
    }
  }
  return lines;
}

/** A trunk whose branches leave it at right angles, and branch again. */
function tree(r, size) {
  const height = 6 + 4 * size;
  const lines = [line([0, 0, 0], [0, 0, height])];
  for (let i = 0; i < 2 * size; ++i) {
    const out = r.pick(AXES.slice(0, 2)).map((x) => x * r.pick([1, -1]) * r.whole(3, 7) || 0);
    const from = [0, 0, 2 + 2 * i + r.whole(0, 1)];
    if (from[2] <= height) {
      const tip = add(from, out);
      lines.push(line(from, tip), line(tip, add(tip, [0, 0, r.whole(2, 4)])));
    }
  }
  return lines;
}

/** Hexagons of 60 degrees, joined by posts. */
function hexagons(r, size) {
  const n = r.whole(4, 8);
  const half = n / 2;
  const high = half * Math.sqrt(3);
  const ring = (z) =>
    loop(
      [n, 0, z],
      [half, high, z],
      [-half, high, z],
      [-n, 0, z],
      [-half, -high, z],
      [half, -high, z],
    );
  const h = r.whole(3, 7);
  const lines = ring(0);
  for (let k = 1; k < size; ++k) {
    lines.push(...ring(k * h), line([n, 0, (k - 1) * h], [n, 0, k * h]));
    lines.push(line([-n, 0, (k - 1) * h], [-n, 0, k * h]));
  }
  return lines;
}

export const FAMILIES = {
  table,
  chair,
  shelf,
  vehicle,
  tower,
  bridge,
  linkage,
  letters,
  polycube,
  lattice,
  tree,
  hexagons,
};

export const SIZES = [1, 2, 3, 4];

function sketchOf(name, drawn) {
  const { lines, joints } = Array.isArray(drawn) ? { lines: drawn, joints: [] } : drawn;
  return {
    format: 'technic-sketch',
    version: 1,
    name,
    lines: (joints.length > 0 ? lines : unique(lines)).map(([from, to]) => ({ from, to })),
    ...(joints.length > 0 ? { joints } : {}),
  };
}

/** @returns {{name: string, family: string, size: number, sketch: object}} variant 1, 2, … of a family. */
export function familySketch(family, size, variant) {
  const place = Object.keys(FAMILIES).indexOf(family);
  const r = random(place * 1_000_003 + size * 10_007 + variant * 101);
  const name = `${family}-${size}-${variant}`;
  return { name, family, size, sketch: sketchOf(name, FAMILIES[family](r, size)) };
}

/** The first `count` sketches of the data set: sizes and families in turn, then further variants. */
export function dataset(count) {
  const kinds = SIZES.flatMap((size) => Object.keys(FAMILIES).map((family) => ({ family, size })));
  return Array.from({ length: count }, (_, i) => {
    const { family, size } = kinds[i % kinds.length];
    return familySketch(family, size, 1 + Math.floor(i / kinds.length));
  });
}

/** The grid of the paper's comparison: n by n cells of 4 by 4. */
export function gridSketch(n) {
  return sketchOf(`grid_${n}`, grid([0, 0, 0], [n, n], 4));
}

export function cubeSketch(side) {
  return sketchOf(`cube_${side}`, box([0, 0, 0], [side, side, side]));
}

/** A sketch with all its lines so many times as long. */
export function scaled(sketch, factor) {
  const times = (p) => p.map((x) => x * factor);
  return {
    ...sketch,
    name: `${sketch.name} x${factor}`,
    lines: sketch.lines.map((l) => ({ ...l, from: times(l.from), to: times(l.to) })),
  };
}
