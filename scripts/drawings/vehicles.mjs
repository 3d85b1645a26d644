// What flies and drives in the gallery.
import { add, line, path, rectangle } from '../lib/families/shapes.mjs';
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

/** One half, on the side of negative y, of a wing with two spars 8 apart. */
function wing(z, half) {
  return [
    line([8, -half, z], [8, 0, z]),
    line([16, -half, z], [16, 0, z]),
    ...[20, 14, 6].map((y) => line([8, -y, z], [16, -y, z])),
    line([8, -half, z], [16, 6 - half, z]),
  ];
}

const wheel = (at, radius) => [...hexagon(at, radius, 1), ...spokes(at, radius, 1)];

export function airplane() {
  const side = [
    line([0, -2, 14], [36, -2, 14]),
    line([0, -2, 8], [24, -2, 8]),
    line([24, -2, 8], [32, -2, 14]),
    ...[0, 8, 16, 24].map((x) => line([x, -2, 8], [x, -2, 14])),
  ];
  const struts = [8, 16].flatMap((x) => [
    line([x, -16, 8], [x, -16, 20]),
    line([x, -2, 14], [x, -2, 20]),
    line([x, -16, 14], [x, -8, 20]),
  ]);
  const across = (x, z) => line([x, -2, z], [x, 2, z]);
  return sketchOf(
    'Airplane',
    {
      propeller: { colour: COLOUR.black, lines: [line([-4, 0, 6], [-4, 0, 14])] },
      shaft: { colour: COLOUR.darkGrey, lines: [line([-4, 0, 10], [0, 0, 10])] },
      wings: { colour: COLOUR.yellow, lines: mirrored([...wing(8, 20), ...wing(20, 20)], 1) },
      struts: { colour: COLOUR.grey, lines: mirrored(struts, 1) },
      tail: {
        colour: COLOUR.yellow,
        lines: [
          ...mirrored(
            [
              line([28, -10, 14], [28, 0, 14]),
              line([36, -10, 14], [36, 0, 14]),
              line([28, -10, 14], [36, -10, 14]),
            ],
            1,
          ),
          line([36, 0, 14], [36, 0, 22]),
          line([28, 0, 14], [28, 0, 18]),
          line([28, 0, 16], [36, 0, 22]),
        ],
      },
      gear: {
        colour: COLOUR.grey,
        lines: [
          ...mirrored([line([4, -2, 8], [4, -2, 0]), line([20, -2, 8], [20, -2, 0])], 1),
          line([4, -2, 0], [4, 2, 0]),
          line([20, -10, 0], [20, 10, 0]),
        ],
      },
      wheels: {
        colour: COLOUR.darkGrey,
        lines: [wheel([4, 0, 0], 4), wheel([20, -10, 0], 4), wheel([20, 10, 0], 4)].flat(),
      },
      fuselage: {
        colour: COLOUR.red,
        lines: [
          ...mirrored(side, 1),
          ...[0, 24].map((x) => across(x, 8)),
          ...[0, 8, 16, 24, 32].map((x) => across(x, 14)),
          across(0, 10),
        ],
      },
    },
    [{ at: [-4, 0, 10], axis: [1, 0, 0], between: [['shaft'], ['propeller']] }],
  );
}

export function raceCar() {
  const z = wheelHeight(4);
  const lift = (lines) => copied(lines, [[0, 0, z]]);
  const across = (x, h, half) => line([x, -half, h], [x, half, h]);
  const side = [
    line([-4, -4, 0], [28, -4, 0]),
    line([4, -4, 6], [20, -4, 6]),
    line([-4, -4, 0], [4, -4, 6]),
    line([20, -4, 0], [20, -4, 6]),
    line([4, -4, 0], [4, -4, 6]),
  ];
  return sketchOf('Race car chassis', {
    wheels: {
      colour: COLOUR.darkGrey,
      lines: lift(mirrored([...wheel([0, -10, 0], 4), ...wheel([24, -10, 0], 4)], 1)),
    },
    axles: { colour: COLOUR.grey, lines: lift([across(0, 0, 10), across(24, 0, 10)]) },
    chassis: {
      colour: COLOUR.red,
      lines: lift([
        ...mirrored(side, 1),
        ...[-4, 8, 16].map((x) => across(x, 0, 4)),
        ...[8, 16].map((x) => across(x, 6, 4)),
      ]),
    },
    nose: {
      colour: COLOUR.yellow,
      lines: lift([
        line([-14, 0, 0], [-4, 0, 0]),
        across(-14, 0, 10),
        across(-10, 0, 10),
        ...mirrored([line([-14, -10, 0], [-10, -10, 0])], 1),
      ]),
    },
    hoop: {
      colour: COLOUR.white,
      lines: lift(path([20, -4, 6], [20, -4, 12], [20, 4, 12], [20, 4, 6])),
    },
    spoiler: {
      colour: COLOUR.yellow,
      lines: lift([
        ...mirrored([line([28, -4, 0], [28, -4, 10])], 1),
        across(28, 10, 10),
        across(32, 10, 10),
        ...mirrored([line([28, -10, 10], [32, -10, 10])], 1),
      ]),
    },
  });
}

/** A solar wing from y = 0 outwards: a mast and two rails with ribs between them, modules along y. */
function solarWing(at, length, step) {
  const n = length / step;
  return [
    ...rungs(
      [-6, 0, 0],
      [-6, length, 0],
      [
        [0, 0, 0],
        [12, 0, 0],
      ],
    ),
    ...rungs([-6, 0, 0], [6, 0, 0], along([0, step, 0], n)),
  ].map((points) => points.map((p) => add(p, at)));
}

export function satellite() {
  const bus = [
    ...rectangle([-6, -6, 0], [12, 12]),
    ...rectangle([-6, -6, 14], [12, 12]),
    ...mirrored(mirrored([line([-6, -6, 0], [-6, -6, 14])], 0), 1),
  ];
  const wing = solarWing([0, 12, 8], 32, 8);
  const boom = [line([0, 6, 8], [0, 44, 8])];
  const dish = [0, 0, 22];
  return sketchOf('Satellite', {
    wings: { colour: COLOUR.blue, lines: mirrored(wing, 1) },
    booms: { colour: COLOUR.white, lines: mirrored(boom, 1) },
    dish: {
      colour: COLOUR.white,
      lines: [...hexagon(dish, 10, 2), ...spokes(dish, 10, 2), line([0, 0, 14], [0, 0, 28])],
    },
    bus: {
      colour: COLOUR.yellow,
      lines: [...bus, line([-6, 0, 14], [6, 0, 14]), ...mirrored([line([-6, 6, 8], [6, 6, 8])], 1)],
    },
  });
}

/** A box of four lines along y with two frames and ends. */
function stationModule([x, y, z], [width, length, height]) {
  return [
    ...copied(
      [line([x, y, z], [x, y + length, z])],
      [
        [0, 0, 0],
        [width, 0, 0],
        [0, 0, height],
        [width, 0, height],
      ],
    ),
    ...copied(rectangle([x, y, z], [width, height], 1), [
      [0, 0, 0],
      [0, length, 0],
    ]),
  ];
}

export function spaceStation() {
  const bays = 12;
  const length = 8 * bays;
  const side = [line([0, 0, 0], [length, 0, 0]), line([0, 0, 6], [length, 0, 6])];
  for (let x = 0; x < length; x += 16) {
    side.push(...path([x, 0, 0], [x + 8, 0, 6], [x + 16, 0, 0]));
  }
  // Beams across lie where no triangle has its corner.
  const low = along([16, 0, 0], bays / 2 - 1).map(([x]) => line([x + 8, 0, 0], [x + 8, 6, 0]));
  const high = along([16, 0, 0], bays / 2).map(([x]) => line([x, 0, 6], [x, 6, 6]));
  const panel = [
    line([0, 6, 6], [0, 46, 6]),
    ...rungs([-8, 14, 6], [-8, 46, 6], along([16, 0, 0], 1)),
    ...rungs([-8, 14, 6], [8, 14, 6], along([0, 8, 0], 4)),
  ];
  return sketchOf('Space station', {
    panels: {
      colour: COLOUR.blue,
      lines: mirrored(
        copied(panel, [
          [16, 0, 0],
          [80, 0, 0],
        ]),
        1,
        3,
      ),
    },
    modules: {
      colour: COLOUR.white,
      lines: [
        ...stationModule([40, -15, -8], [16, 36, 8]),
        ...stationModule([32, -9, 6], [16, 24, 8]),
      ],
    },
    truss: { colour: COLOUR.grey, lines: [...mirrored(side, 1, 3), ...low, ...high] },
  });
}

const TURN = [
  [10, 0],
  [8, 6],
  [6, 8],
  [0, 10],
  [-6, 8],
  [-8, 6],
  [-10, 0],
  [-8, -6],
  [-6, -8],
  [0, -10],
  [6, -8],
  [8, -6],
];

/** A loop of twelve sides on two rails, with the track that leads to it and supports from the ground. */
export function rollerCoaster() {
  const points = [[-5, 0, 6]];
  for (const [dx, dz] of TURN) {
    points.push(add(points.at(-1), [dx, 0, dz]));
  }
  const rail = [...path(...points), line([-37, 0, 6], [-5, 0, 6]), line([5, 0, 6], [37, 0, 6])];
  const rails = [
    [0, 0, 0],
    [0, 6, 0],
  ];
  const stations = [-37, -21, 21, 37].map((x) => [x, 0, 6]);
  const across = (at) => line(at, add(at, [0, 6, 0]));
  const post = (x, z) => [
    line([x, 0, 0], [x, 0, z]),
    line([x, 6, 0], [x, 6, z]),
    line([x, 0, 0], [x, 6, 0]),
  ];
  return sketchOf('Roller coaster loop', {
    rails: { colour: COLOUR.red, lines: copied(rail, rails) },
    ties: { colour: COLOUR.yellow, lines: [...points.slice(0, 12), ...stations].map(across) },
    supports: {
      colour: COLOUR.grey,
      lines: [
        ...[-37, -21, 21, 37].flatMap((x) => post(x, 6)),
        ...[-19, 19].flatMap((x) => post(x, 20)),
        ...copied(
          [
            line([-37, 0, 0], [-5, 0, 0]),
            line([5, 0, 0], [37, 0, 0]),
            ...path([-5, 0, 0], [-5, 0, 6]),
            line([5, 0, 0], [5, 0, 6]),
            line([-5, 0, 0], [5, 0, 0]),
          ],
          rails,
        ),
      ],
    },
  });
}
