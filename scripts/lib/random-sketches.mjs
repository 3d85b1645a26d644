// Sketches made by a seeded generator, of the kinds that people draw and that are hard: frames, trusses with
// 3-4-5 braces, hexagons, stars of many lines, close parallels, crossings, pieces, very long lines.

/** A small generator of whole numbers (mulberry32): the same sketches everywhere. */
export function random(seed) {
  let state = seed >>> 0;
  const unit = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
  return {
    /** A whole number from low to high, both included. */
    whole: (low, high) => low + Math.floor(unit() * (high - low + 1)),
    pick: (items) => items[Math.floor(unit() * items.length)],
    chance: (share) => unit() < share,
  };
}

const add = (a, b) => a.map((x, i) => x + b[i]);
const AXES = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

const upright = (at, height) => [at, add(at, [0, 0, height])];

/** The twelve edges of a box, those below only where `feet` says so. */
function boxEdges(at, [w, d, h], feet = true) {
  const corner = (x, y, z) => add(at, [x * w, y * d, z * h]);
  const lines = [];
  for (const z of feet ? [0, 1] : [1]) {
    lines.push([corner(0, 0, z), corner(1, 0, z)], [corner(0, 1, z), corner(1, 1, z)]);
    lines.push([corner(0, 0, z), corner(0, 1, z)], [corner(1, 0, z), corner(1, 1, z)]);
  }
  for (const [x, y] of [
    [0, 0],
    [1, 0],
    [0, 1],
    [1, 1],
  ]) {
    lines.push([corner(x, y, 0), corner(x, y, 1)]);
  }
  return lines;
}

const KINDS = {
  box: (r) => boxEdges([0, 0, 0], [r.whole(3, 20), r.whole(3, 20), r.whole(3, 20)]),
  table: (r) => {
    const size = [r.whole(6, 16), r.whole(4, 12), r.whole(4, 12)];
    const lines = boxEdges([0, 0, 0], size, false);
    if (r.chance(0.5)) {
      const z = r.whole(1, size[2] - 2);
      lines.push(
        [
          [0, 0, z],
          [0, size[1], z],
        ],
        [
          [size[0], 0, z],
          [size[0], size[1], z],
        ],
      );
    }
    return lines;
  },
  /** Boxes side by side and on top of each other that share edges. */
  shelf: (r) => {
    const [w, d, h] = [r.whole(4, 10), r.whole(4, 10), r.whole(4, 8)];
    const lines = [];
    const [columns, rows] = [r.whole(1, 3), r.whole(1, 3)];
    for (let i = 0; i < columns; ++i) {
      for (let k = 0; k < rows; ++k) {
        lines.push(...boxEdges([i * w, 0, k * h], [w, d, h]));
      }
    }
    return lines;
  },
  /** A flat girder with 3-4-5 or 6-8-10 braces between its chords. */
  truss: (r) => {
    const scale = r.pick([1, 2]);
    const bays = r.whole(2, 5);
    const [w, h] = r.chance(0.5) ? [4 * scale, 3 * scale] : [3 * scale, 4 * scale];
    const lines = [
      [
        [0, 0, 0],
        [bays * w, 0, 0],
      ],
      [
        [0, 0, h],
        [bays * w, 0, h],
      ],
    ];
    for (let i = 0; i <= bays; ++i) {
      lines.push([
        [i * w, 0, 0],
        [i * w, 0, h],
      ]);
      if (i < bays && r.chance(0.8)) {
        lines.push(
          r.chance(0.5)
            ? [
                [i * w, 0, 0],
                [(i + 1) * w, 0, h],
              ]
            : [
                [(i + 1) * w, 0, 0],
                [i * w, 0, h],
              ],
        );
      }
    }
    return lines;
  },
  /** A house with a 3-4-5 roof. */
  roof: (r) => {
    const scale = r.pick([1, 2]);
    const [d, h] = [r.whole(5, 14), r.whole(4, 9)];
    const w = 8 * scale;
    const lines = boxEdges([0, 0, 0], [w, d, h]);
    for (const y of [0, d]) {
      const top = [4 * scale, y, h + 3 * scale];
      lines.push([[0, y, h], top], [[w, y, h], top]);
    }
    lines.push([
      [4 * scale, 0, h + 3 * scale],
      [4 * scale, d, h + 3 * scale],
    ]);
    return lines;
  },
  /** A hexagon or triangle of 60 degrees, with spokes or posts. */
  sixty: (r) => {
    const n = r.whole(4, 12);
    const at = (i) => [n * Math.cos((i * Math.PI) / 3), n * Math.sin((i * Math.PI) / 3), 0];
    const lines = [0, 1, 2, 3, 4, 5].map((i) => [at(i), at(i + 1)]);
    if (r.chance(0.5)) {
      lines.push(...[0, 1, 2, 3, 4, 5].map((i) => [[0, 0, 0], at(i)]).slice(0, r.whole(1, 6)));
    } else {
      const h = r.whole(3, 9);
      lines.push(...[0, 2, 4].map((i) => [at(i), add(at(i), [0, 0, h])]));
    }
    return lines;
  },
  /** Up to six lines at one node, some with a frame around their ends. */
  star: (r) => {
    const lines = [];
    for (const axis of AXES) {
      for (const sign of [1, -1]) {
        if (lines.length < 3 || r.chance(0.7)) {
          lines.push([[0, 0, 0], axis.map((x) => sign * x * r.whole(3, 9) || 0)]);
        }
      }
    }
    return lines;
  },
  /** Lines side by side one or two modules apart, joined by rungs. */
  ladder: (r) => {
    const [n, gap, height] = [r.whole(2, 5), r.whole(1, 3), r.whole(0, 6)];
    const [length, step] = [r.whole(5, 18), r.whole(2, 5)];
    const lines = [];
    for (let i = 0; i < n; ++i) {
      lines.push([
        [0, i * gap, 0],
        [length, i * gap, 0],
      ]);
    }
    for (let x = 0; x <= length; x += step) {
      lines.push([
        [x, 0, 0],
        [x, (n - 1) * gap, 0],
      ]);
    }
    if (height > 2) {
      lines.push([
        [0, 0, 0],
        [0, 0, height],
      ]);
    }
    return lines;
  },
  /** Lines that cross anywhere, also between nodes, in one plane. */
  crossing: (r) => [
    [
      [0, 0, 0],
      [12, 0, 0],
    ],
    [
      [0, 9, 0],
      [12, 9, 0],
    ],
    [
      [0, 0, 0],
      [0, 9, 0],
    ],
    [
      [12, 0, 0],
      [12, 9, 0],
    ],
    [
      [0, 0, 0],
      [12, 9, 0],
    ],
    ...(r.chance(0.7)
      ? [
          [
            [0, 9, 0],
            [12, 0, 0],
          ],
        ]
      : []),
    ...(r.chance(0.5) ? [upright([r.whole(2, 10), 0, 0], r.whole(3, 8))] : []),
  ],
  /** A walk of lines along the axes, with branches. */
  tree: (r) => {
    const ends = [[0, 0, 0]];
    const lines = [];
    const branches = r.whole(4, 14);
    for (let i = 0; i < branches; ++i) {
      const from = r.pick(ends);
      const step = r.pick(AXES).map((x) => x * r.whole(2, 9) * r.pick([1, -1]) || 0);
      const to = add(from, step);
      lines.push([from, to]);
      ends.push(to);
    }
    return lines;
  },
  /** Parts of a lattice of cells, as in scaffolds. */
  lattice: (r) => {
    const cell = r.whole(3, 7);
    const lines = [];
    const size = [r.whole(1, 3), r.whole(1, 3), r.whole(1, 2)];
    for (const [a, axis] of AXES.entries()) {
      for (let i = 0; i <= size[(a + 1) % 3]; ++i) {
        for (let j = 0; j <= size[(a + 2) % 3]; ++j) {
          const from = [0, 0, 0];
          from[(a + 1) % 3] = i * cell;
          from[(a + 2) % 3] = j * cell;
          if (r.chance(0.9)) {
            lines.push([
              from,
              add(
                from,
                axis.map((x) => x * cell * size[a]),
              ),
            ]);
          }
        }
      }
    }
    return lines;
  },
  /** Many lines in a small box: they cross, touch and run side by side. */
  dense: (r) => {
    const size = r.whole(6, 10);
    const lines = [];
    const count = r.whole(6, 20);
    for (let i = 0; i < count; ++i) {
      const axis = r.whole(0, 2);
      const from = [0, 1, 2].map(() => r.pick([0, 2, 4, 6, size]));
      from[axis] = 0;
      const to = [...from];
      to[axis] = size;
      lines.push([from, to]);
    }
    return lines;
  },
  /** A tower of storeys with 3-4-5 braces on its faces. */
  tower: (r) => {
    const [w, h] = r.pick([
      [8, 6],
      [6, 8],
      [4, 3],
      [3, 4],
    ]);
    const lines = [];
    const storeys = r.whole(1, 3);
    for (let k = 0; k < storeys; ++k) {
      lines.push(...boxEdges([0, 0, k * h], [w, w, h]));
      for (const [from, to] of [
        [
          [0, 0, 0],
          [w, 0, h],
        ],
        [
          [0, w, 0],
          [w, w, h],
        ],
        [
          [0, 0, 0],
          [0, w, h],
        ],
        [
          [w, 0, 0],
          [w, w, h],
        ],
      ]) {
        if (r.chance(0.6)) {
          lines.push([add(from, [0, 0, k * h]), add(to, [0, 0, k * h])]);
        }
      }
    }
    return lines;
  },
  long: (r) => {
    const n = r.whole(30, 120);
    const lines = [
      [
        [0, 0, 0],
        [n, 0, 0],
      ],
    ];
    const branches = r.whole(1, 6);
    for (let i = 0; i < branches; ++i) {
      const x = r.whole(0, n);
      lines.push([
        [x, 0, 0],
        [x, r.pick([1, -1]) * r.whole(3, 12), 0],
      ]);
    }
    return lines;
  },
};

/** @returns {{ name: string, sketch: object }} one sketch; its kind follows from the number. */
export function randomSketch(number) {
  const r = random(number * 7919 + 17);
  const kinds = Object.keys(KINDS);
  const kind = kinds[number % kinds.length];
  const lines = KINDS[kind](r).map(([from, to]) => ({ from, to }));
  const name = `${kind}_${number}`;
  return { name, sketch: { format: 'technic-sketch', version: 1, name, lines } };
}
