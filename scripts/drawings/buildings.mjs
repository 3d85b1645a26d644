// Houses, towers and bridges of the gallery.
import { add, line, path, posts, rectangle } from '../lib/families/shapes.mjs';
import { along, COLOUR, copied, mirrored, rungs, sketchOf } from './pen.mjs';

export function house() {
  const gable = path([0, 0, 10], [8, 0, 16], [16, 0, 10]);
  return sketchOf('House', {
    door: {
      colour: COLOUR.brown,
      lines: path([6, 0, 0], [6, 0, 8], [10, 0, 8], [10, 0, 0]),
    },
    window: {
      colour: COLOUR.azure,
      lines: [
        ...rungs([0, 4, 0], [0, 4, 10], along([0, 4, 0], 1)),
        ...rungs([0, 4, 4], [0, 8, 4], along([0, 0, 4], 1)),
      ],
    },
    chimney: {
      colour: COLOUR.darkGrey,
      lines: [
        ...path([4, 8, 10], [4, 8, 19], [4, 12, 19], [4, 12, 10]),
        line([0, 8, 10], [16, 8, 10]),
      ],
    },
    walls: {
      colour: COLOUR.tan,
      lines: [
        ...rectangle([0, 0, 0], [16, 12]),
        ...rectangle([0, 0, 10], [16, 12]),
        ...posts([0, 0, 0], [16, 12, 10]),
      ],
    },
    roof: {
      colour: COLOUR.red,
      lines: [...copied(gable, along([0, 4, 0], 3)), line([8, 0, 16], [8, 12, 16])],
    },
  });
}

const TOWERS = [
  [0, 0, 0],
  [36, 0, 0],
  [0, 36, 0],
  [36, 36, 0],
];

/** A gable roof over a square of 12 that begins at `at`. */
function gableRoof(at) {
  return [
    ...copied(path([0, 0, 0], [6, 0, 8], [12, 0, 0]), along([0, 12, 0], 1)),
    line([6, 0, 8], [6, 12, 8]),
  ].map((points) => points.map((point) => add(at, point)));
}

/** A square tower of 12 with rings every 12 up to `height`, its corners a little higher. */
function squareTower(at, height) {
  return [
    ...posts(at, [12, 12, height + 4]),
    ...copied(rectangle(at, [12, 12]), along([0, 0, 12], height / 12)),
  ];
}

export function castle() {
  const keep = [18, 18, 0];
  const wall = [
    line([12, 4, 0], [36, 4, 0]),
    line([12, 4, 12], [36, 4, 12]),
    line([16, 4, 0], [16, 4, 16]),
    line([20, 4, 0], [20, 4, 16]),
    line([28, 4, 0], [28, 4, 16]),
    line([32, 4, 0], [32, 4, 16]),
  ];
  const aside = wall.map((points) => points.map(([x, y, z]) => [y, x, z]));
  return sketchOf('Castle', {
    gate: {
      colour: COLOUR.brown,
      lines: [
        line([20, 4, 8], [28, 4, 8]),
        line([24, 4, 0], [24, 4, 8]),
        line([20, 4, 4], [28, 4, 4]),
      ],
    },
    roofs: {
      colour: COLOUR.red,
      lines: [
        ...TOWERS.flatMap((at) => gableRoof(add(at, [0, 0, 28]))),
        ...gableRoof(add(keep, [0, 0, 40])),
      ],
    },
    flag: {
      colour: COLOUR.yellow,
      lines: [
        line([24, 24, 48], [24, 24, 58]),
        ...path([24, 24, 58], [30, 24, 58], [30, 24, 54], [24, 24, 54]),
      ],
    },
    towers: { colour: COLOUR.grey, lines: TOWERS.flatMap((at) => squareTower(at, 24)) },
    keep: {
      colour: COLOUR.darkGrey,
      lines: [
        ...squareTower(keep, 36),
        ...copied(
          [line([18, 4, 0], [18, 18, 0]), line([18, 30, 0], [18, 44, 0])],
          [
            [0, 0, 0],
            [12, 0, 0],
          ],
        ),
      ],
    },
    walls: {
      colour: COLOUR.grey,
      lines: [...mirrored(wall, 1, 24), ...mirrored(aside, 0, 24)],
    },
  });
}

/**
 * One side of a tower that leans inwards from its feet, then rises straight: all of it right triangles of 6, 8 and 10.
 * @param bays of a leg; they meet in the middle at 8 times as many modules
 * @param shaft bays above that
 */
function latticeTower(bays, shaft) {
  const leg = [];
  const outer = (k) => [-6 * (bays + 1) + 6 * k, 0, 8 * k];
  const inner = (k) => add(outer(k), [6, 0, 0]);
  for (let k = 0; k < bays; ++k) {
    leg.push(line(outer(k), inner(k)), line(inner(k), outer(k + 1)));
    leg.push(line(outer(k), outer(k + 1)), line(inner(k), inner(k + 1)));
  }
  const foot = 8 * bays;
  const top = foot + 8 * shaft;
  const trunk = [];
  for (let z = foot; z < top; z += 8) {
    trunk.push(line([-6, 0, z], [-6, 0, z + 8]), line([-6, 0, z], [0, 0, z + 8]));
  }
  const rings = along([0, 0, 8], shaft).flatMap((by) =>
    copied([line([-6, 0, foot], [6, 0, foot])], [by]),
  );
  const tip = [line([-6, 0, top], [0, 0, top + 8])];
  return {
    legs: mirrored(leg, 0),
    shaft: [...mirrored(trunk, 0), ...rings, ...mirrored(tip, 0)],
    top: top + 8,
  };
}

/** A floor across a lattice tower from leg to leg above bay k, as a truss; it hangs on the middles of the uprights. */
function platform(bays, k) {
  const half = 6 * (bays - k);
  const z = 8 * k + 4;
  const zigzag = [];
  for (let x = 6 - half; x < half - 6; x += 12) {
    zigzag.push(...path([x, 0, z], [x + 6, 0, z + 8], [x + 12, 0, z]));
  }
  return [
    line([-half, 0, z], [half, 0, z]),
    line([6 - half, 0, z + 8], [half - 6, 0, z + 8]),
    ...zigzag,
  ];
}

export function flatTower() {
  const { legs, shaft, top } = latticeTower(8, 9);
  return sketchOf('Flat tower', {
    mast: { colour: COLOUR.red, lines: [line([0, 0, top], [0, 0, top + 14])] },
    floors: { colour: COLOUR.orange, lines: [1, 3, 5].flatMap((k) => platform(8, k)) },
    legs: { colour: COLOUR.brown, lines: legs },
    shaft: { colour: COLOUR.brown, lines: shaft },
  });
}

export function tower() {
  const bays = 6;
  const { legs, shaft, top } = latticeTower(bays, 5);
  const deep = (lines) =>
    copied(lines, [
      [0, 0, 0],
      [0, 8, 0],
    ]);
  const across = ([x, z]) => line([x, 0, z], [x, 8, z]);
  // In the middles of slanting and upright lines, where nothing else meets them.
  const legTies = Array.from({ length: bays }, (_, k) => [
    [-6 * (bays + 1 - k) + 3, 8 * k + 4],
    [-6 * (bays - k) + 3, 8 * k + 4],
  ]).flat();
  const shaftTies = along([0, 0, 8], 4).map(([, , z]) => [-6, 8 * bays + 4 + z]);
  const both = [...legTies, ...shaftTies].flatMap(([x, z]) => [
    [x, z],
    [-x, z],
  ]);
  return sketchOf('Tower', {
    floors: { colour: COLOUR.orange, lines: deep([1, 3].flatMap((k) => platform(bays, k))) },
    legs: { colour: COLOUR.brown, lines: deep(legs) },
    shaft: { colour: COLOUR.brown, lines: deep(shaft) },
    ties: { colour: COLOUR.red, lines: [...both, [0, top]].map(across) },
    mast: { colour: COLOUR.red, lines: [line([0, 4, top], [0, 4, top + 12])] },
  });
}

/** A truss with a road through it: two sides of 6-8-10 triangles, portals, and beams across. */
export function trussBridge() {
  const [bays, width, deck] = [6, 12, 12];
  const end = 12 * bays;
  const side = [line([0, 0, deck], [end, 0, deck]), line([6, 0, deck + 8], [end - 6, 0, deck + 8])];
  for (let x = 0; x < end; x += 12) {
    side.push(...path([x, 0, deck], [x + 6, 0, deck + 8], [x + 12, 0, deck]));
  }
  const pier = [
    line([0, 0, 0], [0, 0, deck]),
    line([-6, 0, 0], [6, 0, 0]),
    line([-6, 0, 0], [0, 0, 8]),
    line([6, 0, 0], [0, 0, 8]),
  ];
  return sketchOf('Truss bridge', {
    trusses: { colour: COLOUR.red, lines: mirrored(side, 1, width / 2) },
    road: {
      colour: COLOUR.darkGrey,
      lines: [
        ...rungs([6, 0, deck], [6, width, deck], along([12, 0, 0], bays - 1)),
        ...rungs([6, 4, deck], [end - 6, 4, deck], along([0, 4, 0], 1)),
      ],
    },
    portals: {
      colour: COLOUR.red,
      lines: rungs([12, 0, deck + 8], [12, width, deck + 8], along([12, 0, 0], bays - 2)),
    },
    piers: {
      colour: COLOUR.tan,
      lines: mirrored(
        [...mirrored(pier, 1, width / 2), line([0, 0, 0], [0, width, 0])],
        0,
        end / 2,
      ),
    },
  });
}

/** An arm's lattice from the hub outwards: one rail beside the arm and the rungs between. `turn` in quarters. */
function sail([x, y, z], turn) {
  const spun = (a, b) =>
    [
      [x + a, y, z + b],
      [x - b, y, z + a],
      [x - a, y, z - b],
      [x + b, y, z - a],
    ][turn];
  return [line(spun(6, 4), spun(14, 4)), ...[6, 10, 14].map((a) => line(spun(a, 0), spun(a, 4)))];
}

export function windmill() {
  const hub = [0, -4, 20];
  const face = [
    ...mirrored([line([-12, 0, 0], [-6, 0, 8]), line([-6, 0, 8], [-6, 0, 24])], 0),
    line([-12, 0, 0], [12, 0, 0]),
    ...[8, 20, 24].map((z) => line([-6, 0, z], [6, 0, z])),
  ];
  const deep = [
    [0, 0, 0],
    [0, 12, 0],
  ];
  return sketchOf(
    'Windmill',
    {
      door: { colour: COLOUR.brown, lines: mirrored([line([-2, 0, 0], [-2, 0, 8])], 0) },
      cap: {
        colour: COLOUR.red,
        lines: [
          ...copied(path([-6, 0, 24], [0, 0, 32], [6, 0, 24]), deep),
          line([0, 0, 32], [0, 12, 32]),
        ],
      },
      arms: {
        colour: COLOUR.darkGrey,
        lines: [line([-14, -4, 20], [14, -4, 20]), line([0, -4, 6], [0, -4, 34])],
      },
      sails: { colour: COLOUR.white, lines: [0, 1, 2, 3].flatMap((turn) => sail(hub, turn)) },
      shaft: { colour: COLOUR.darkGrey, lines: [line(hub, [0, 6, 20])] },
      bearing: { colour: COLOUR.tan, lines: [line([-6, 6, 20], [6, 6, 20])] },
      tower: {
        colour: COLOUR.tan,
        lines: [
          ...copied(face, deep),
          ...mirrored(
            [
              line([-12, 0, 0], [-12, 12, 0]),
              ...rungs([-6, 0, 12], [-6, 12, 12], along([0, 0, 8], 1)),
            ],
            0,
          ),
        ],
      },
    },
    [{ at: hub, axis: [0, 1, 0], between: [['shaft'], ['arms']] }],
  );
}

/** Two rails that fall 6 over 8 from side to side of a tower, landing below landing. */
export function marbleRun() {
  const floors = 5;
  const ramp = (z) => path([0, 2, z], [8, 2, z - 6], [12, 2, z - 6]);
  const ramps = Array.from({ length: floors }, (_, i) => {
    const right = ramp(8 * (floors - i) + 2);
    return i % 2 === 0 ? right : mirrored(right, 0, 6).slice(right.length);
  }).flat();
  const landings = Array.from({ length: floors }, (_, i) => {
    const z = 8 * (floors - i) - 4;
    return i % 2 === 0 ? [12, 0, z] : [0, 0, z];
  });
  const starts = Array.from({ length: floors }, (_, i) => [
    i % 2 === 0 ? 0 : 12,
    0,
    8 * (floors - i) + 2,
  ]);
  const height = 8 * floors + 6;
  return sketchOf('Marble run tower', {
    ramps: {
      colour: COLOUR.orange,
      lines: copied(ramps, [
        [0, 0, 0],
        [0, 4, 0],
      ]),
    },
    funnel: {
      colour: COLOUR.red,
      lines: rectangle([0, 0, height], [12, 8]),
    },
    tower: {
      colour: COLOUR.azure,
      lines: [
        ...posts([0, 0, 0], [12, 8, height]),
        ...rectangle([0, 0, 0], [12, 8]),
        ...[...landings, ...starts].map((at) => line(at, add(at, [0, 8, 0]))),
      ],
    },
  });
}
