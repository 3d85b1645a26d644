// Bows, chairs and other things of the gallery.
import { add, box, line, path, posts, rectangle } from '../lib/families/shapes.mjs';
import {
  along,
  COLOUR,
  copied,
  hexagon,
  mirrored,
  rungs,
  sketchOf,
  spokes,
  wheelHeight,
} from './pen.mjs';

/** A strip of two bays of 6-8-10 triangles that leans by 6 for each 8, and its tip; in the plane of z. */
function limb([x, y, z]) {
  const near = (k) => [x + 6 * k, y + 8 * k, z];
  const far = (k) => add(near(k), [-6, 0, 0]);
  const bays = [0, 1].flatMap((k) => [
    line(far(k), near(k)),
    line(near(k), far(k + 1)),
    line(near(k), near(k + 1)),
    line(far(k), far(k + 1)),
  ]);
  return [...bays, line(far(2), near(2)), line(near(2), add(near(2), [8, 6, 0]))];
}

export function crossbow() {
  const top = 12;
  const stations = along([4, 0, 0], 10).map(([x]) => x + 8);
  const side = [
    line([0, -2, top], [56, -2, top]),
    line([8, -2, 6], [48, -2, 6]),
    ...stations.map((x) => line([x, -2, 6], [x, -2, top])),
    line([48, -2, 6], [56, -2, 0]),
    line([56, -2, 0], [56, -2, top]),
  ];
  return sketchOf(
    'Crossbow',
    {
      trigger: { colour: COLOUR.black, lines: [line([42, -2, 6], [42, -2, 0])] },
      arrow: { colour: COLOUR.yellow, lines: [line([-8, 0, top], [38, 0, top])] },
      stirrup: {
        colour: COLOUR.darkGrey,
        lines: path([0, -2, top], [-8, -2, top], [-8, 2, top], [0, 2, top]),
      },
      string: { colour: COLOUR.white, lines: mirrored([line([20, 24, top], [38, 0, top])], 1) },
      bow: { colour: COLOUR.red, lines: mirrored(limb([0, 2, top]), 1) },
      stock: {
        colour: COLOUR.brown,
        lines: [
          ...mirrored(side, 1),
          ...[0, 10, 18, 26, 38, 46, 54].map((x) => line([x, -2, top], [x, 2, top])),
          ...[10, 18, 22, 26, 30, 34, 38, 46].map((x) => line([x, -2, 6], [x, 2, 6])),
          line([56, -2, 0], [56, 2, 0]),
        ],
      },
      legs: {
        colour: COLOUR.darkGrey,
        lines: mirrored([line([14, -2, 6], [14, -10, 0]), line([10, -10, 0], [18, -10, 0])], 1),
      },
    },
    [{ at: [42, -2, 6], axis: [0, 1, 0], between: [['stock'], ['trigger']] }],
  );
}

/** It lies on the table, drawn, with an arrow on the string. */
export function longBow() {
  const layers = [
    [0, 0, 0],
    [0, 0, 4],
  ];
  const half = [...limb([0, 6, 0]), line([0, 0, 0], [0, 6, 0]), line([-6, 0, 0], [-6, 6, 0])];
  const tip = [20, 28, 0];
  return sketchOf('Long bow', {
    arrow: {
      colour: COLOUR.yellow,
      lines: [line([-14, 0, 4], [41, 0, 4])],
    },
    string: { colour: COLOUR.white, lines: mirrored([line(add(tip, [0, 0, 4]), [41, 0, 4])], 1) },
    bow: { colour: COLOUR.brown, lines: copied(mirrored(half, 1), layers) },
    ties: {
      colour: COLOUR.red,
      lines: mirrored(
        [
          [0, 6],
          [-6, 6],
          [6, 14],
          [12, 22],
          [20, 28],
        ].map(([x, y]) => line([x, y, 0], [x, y, 4])),
        1,
      ),
    },
  });
}

export function bicycle() {
  const z = wheelHeight(6);
  const at = (x, h, y = 0) => [x, y, z + h];
  const wheelOf = (x) => [...hexagon(at(x, 0), 6, 1), ...spokes(at(x, 0), 6, 1)];
  return sketchOf('Bicycle', {
    wheels: { colour: COLOUR.darkGrey, lines: [...wheelOf(0), ...wheelOf(18)] },
    saddle: { colour: COLOUR.black, lines: [line(at(4, 12), at(8, 12))] },
    bar: {
      colour: COLOUR.black,
      lines: [
        line(at(12, 12, -4), at(12, 12, 4)),
        ...[-4, 4].map((y) => line(at(12, 12, y), at(8, 12, y))),
      ],
    },
    frame: {
      colour: COLOUR.red,
      lines: [
        line(at(0, 0), at(6, 0)),
        line(at(0, 0), at(6, 8)),
        line(at(6, 0), at(6, 12)),
        line(at(6, 8), at(12, 8)),
        line(at(6, 0), at(12, 8)),
        line(at(12, 8), at(18, 0)),
        line(at(12, 8), at(12, 12)),
      ],
    },
    pedals: { colour: COLOUR.grey, lines: [line(at(6, 0, -4), at(6, 0, 4))] },
  });
}

export function chair() {
  const seat = 12;
  return sketchOf('Chair from the front', {
    cushion: { colour: COLOUR.red, lines: rungs([4, 0, seat], [4, 12, seat], along([4, 0, 0], 1)) },
    slats: { colour: COLOUR.red, lines: rungs([4, 12, 18], [4, 12, 30], along([4, 0, 0], 1)) },
    arms: {
      colour: COLOUR.brown,
      lines: mirrored([line([0, 0, seat], [0, 0, 18]), line([0, 0, 18], [0, 12, 18])], 0, 6),
    },
    frame: {
      colour: COLOUR.brown,
      lines: [
        ...posts([0, 0, 0], [12, 12, seat]),
        ...rectangle([0, 0, seat], [12, 12]),
        ...rectangle([0, 0, 4], [12, 12]),
        line([0, 6, 4], [12, 6, 4]),
        ...mirrored([line([0, 12, seat], [0, 12, 30])], 0, 6),
        ...rungs([0, 12, 18], [12, 12, 18], along([0, 0, 12], 1)),
        line([0, 12, 24], [12, 12, 24]),
      ],
    },
  });
}

/** Two towers, main cables that fall 6 for each 8, hangers, and a road. */
export function suspensionBridge() {
  const [deck, width] = [12, 10];
  const cables = [line([8, 0, 24], [24, 0, 36]), line([24, 0, 36], [48, 0, 18])];
  const hangers = [
    [8, 24],
    [16, 30],
    [32, 30],
    [40, 24],
    [48, 18],
  ].map(([x, z]) => line([x, 0, deck], [x, 0, z]));
  const sides = (lines) => mirrored(mirrored(lines, 0), 1, width / 2);
  const across = (x, z) => line([x, 0, z], [x, width, z]);
  return sketchOf('Bridge', {
    cables: { colour: COLOUR.red, lines: sides([...cables, line([0, 0, 24], [8, 0, 24])]) },
    hangers: { colour: COLOUR.grey, lines: sides(hangers) },
    towers: {
      colour: COLOUR.red,
      lines: mirrored(
        [
          ...mirrored([line([24, 0, 0], [24, 0, 36]), line([20, 0, 0], [28, 0, 0])], 1, width / 2),
          across(24, 0),
          across(24, 24),
          across(24, 36),
        ],
        0,
      ),
    },
    road: {
      colour: COLOUR.darkGrey,
      lines: [
        ...mirrored([line([-48, 0, deck], [48, 0, deck])], 1, width / 2),
        ...along([8, 0, 0], 12).map(([x]) => across(x - 48, deck)),
      ],
    },
    piers: {
      colour: COLOUR.tan,
      lines: mirrored(
        [...mirrored([line([48, 0, 0], [48, 0, deck])], 1, width / 2), across(48, 0)],
        0,
      ),
    },
  });
}

export function cube() {
  return sketchOf('Cube', { edges: { colour: COLOUR.yellow, lines: box([0, 0, 0], [8, 8, 8]) } });
}
