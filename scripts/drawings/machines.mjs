// Cranes, diggers and desktop machines of the gallery.
import { add, box, line, path, posts, rectangle } from '../lib/families/shapes.mjs';
import { along, COLOUR, copied, hexagon, mirrored, rungs, sketchOf, spokes } from './pen.mjs';

/**
 * A zigzag of 6-8-10 triangles on the side y = -4, from point to point; `step` along x and z.
 * Beams across belong where it does not touch: three beams on one pin are enough.
 */
function zigzag([x, z], steps) {
  const points = [[x, -4, z]];
  for (const [dx, dz] of steps) {
    points.push(add(points.at(-1), [dx, 0, dz]));
  }
  return path(...points);
}

const repeated = (steps, n) => Array.from({ length: n }, (_, i) => steps[i % steps.length]);

/** How high a crane's jib is. */
const DECK = 52;
const craneAcross = (x, z) => line([x, -4, z], [x, 4, z]);

function craneJib() {
  const side = [
    line([-20, -4, DECK], [52, -4, DECK]),
    line([-12, -4, DECK + 6], [44, -4, DECK + 6]),
    ...zigzag(
      [4, DECK],
      repeated(
        [
          [8, 6],
          [8, -6],
        ],
        6,
      ),
    ),
    line([-20, -4, DECK], [-12, -4, DECK + 6]),
  ];
  return [
    ...mirrored(side, 1),
    ...[-12, 12, 28, 44].map((x) => craneAcross(x, DECK)),
    ...[-4, 4, 20, 36].map((x) => craneAcross(x, DECK + 6)),
  ];
}

function craneMast() {
  const side = [
    line([-4, -4, 0], [-4, -4, DECK + 6]),
    line([4, -4, 0], [4, -4, DECK + 6]),
    ...zigzag(
      [-4, 6],
      repeated(
        [
          [8, 6],
          [-8, 6],
        ],
        7,
      ),
    ),
  ];
  return [
    ...mirrored(side, 1),
    ...[12, 24, 36, 48].map((z) => craneAcross(-4, z)),
    ...[18, 30, 42].map((z) => craneAcross(4, z)),
  ];
}

function craneWeight() {
  const low = DECK - 8;
  const side = path([-16, -4, DECK], [-16, -4, low], [-8, -4, low], [-8, -4, DECK]);
  return [...mirrored(side, 1), craneAcross(-16, low), craneAcross(-8, low)];
}

export function crane() {
  const top = DECK + 18;
  const low = DECK - 24;
  return sketchOf('Crane', {
    hook: {
      colour: COLOUR.black,
      lines: path([44, 0, DECK], [44, 0, low], [48, 0, low], [48, 0, low + 4]),
    },
    weight: { colour: COLOUR.darkGrey, lines: craneWeight() },
    stays: {
      colour: COLOUR.red,
      lines: [
        ...mirrored(path([0, -4, DECK + 6], [0, -4, top], [16, -4, DECK + 6]), 1),
        craneAcross(0, top),
      ],
    },
    jib: { colour: COLOUR.yellow, lines: craneJib() },
    mast: { colour: COLOUR.yellow, lines: craneMast() },
    foot: {
      colour: COLOUR.darkGrey,
      lines: [
        ...mirrored([line([-16, -4, 0], [16, -4, 0])], 1),
        ...mirrored([line([-4, -16, 0], [-4, 16, 0])], 0),
        ...mirrored(mirrored([line([-12, -4, 0], [-4, -4, 6])], 0), 1),
      ],
    },
  });
}

export function excavator() {
  const track = [
    line([-8, -8, 0], [8, -8, 0]),
    line([-16, -8, 6], [16, -8, 6]),
    ...mirrored([line([8, -8, 0], [16, -8, 6]), line([8, -8, 0], [8, -8, 10])], 0),
  ];
  const pivot = [12, 4, 10];
  const elbow = [36, 4, 26];
  const wrist = [48, 4, 10];
  return sketchOf(
    'Excavator arm',
    {
      bucket: {
        colour: COLOUR.darkGrey,
        lines: [
          ...path(wrist, [48, 4, 2], [40, 4, 2]),
          line([48, 0, 2], [48, 8, 2]),
          line([40, 0, 2], [40, 8, 2]),
          ...mirrored([line([40, 0, 2], [48, 0, 2])], 1, 4),
        ],
      },
      stick: { colour: COLOUR.orange, lines: [line([30, 4, 34], wrist)] },
      boom: {
        colour: COLOUR.orange,
        lines: [...path(pivot, [24, 4, 26], elbow), line([15, 4, 14], [31, 4, 26])],
      },
      cab: {
        colour: COLOUR.azure,
        lines: [...posts([0, -8, 10], [8, 8, 10]), ...rectangle([0, -8, 20], [8, 8])],
      },
      house: {
        colour: COLOUR.orange,
        lines: [
          ...rectangle([-16, -8, 10], [24, 16]),
          line([-16, 4, 10], [12, 4, 10]),
          line([-16, 0, 10], [8, 0, 10]),
          ...rungs([-8, -8, 10], [-8, 8, 10], along([8, 0, 0], 1)),
          ...posts([-16, -8, 10], [8, 16, 6]),
          ...rectangle([-16, -8, 16], [8, 16]),
        ],
      },
      tracks: {
        colour: COLOUR.black,
        lines: [...mirrored(track, 1), ...rungs([-8, -8, 6], [-8, 8, 6], along([16, 0, 0], 1))],
      },
    },
    [
      { at: pivot, axis: [0, 1, 0], between: [['house'], ['boom']] },
      { at: elbow, axis: [0, 1, 0], between: [['boom'], ['stick']] },
      { at: wrist, axis: [0, 1, 0], between: [['stick'], ['bucket']] },
    ],
  );
}

const HALF_BED = 18;

function printerPortal() {
  const post = [
    line([0, 14, 6], [0, 14, 48]),
    line([0, 22, 6], [0, 22, 48]),
    ...rungs([0, 14, 12], [0, 22, 12], along([0, 0, 12], 3)),
    ...rungs([0, 22, 12], [0, 14, 18], along([0, 0, 12], 2)),
  ];
  return [...mirrored(post, 0, HALF_BED), ...rungs([0, 14, 48], [36, 14, 48], along([0, 8, 0], 1))];
}

function printerBase() {
  return [
    ...rectangle([0, 0, 0], [36, 36]),
    ...rectangle([0, 0, 6], [36, 36]),
    ...posts([0, 0, 0], [36, 36, 6]),
    ...mirrored(rungs([0, 14, 0], [0, 14, 6], along([0, 8, 0], 1)), 0, HALF_BED),
    ...mirrored(rungs([12, 0, 0], [12, 0, 6], along([12, 0, 0], 1)), 1, HALF_BED),
    ...rungs([12, 0, 6], [12, 36, 6], along([12, 0, 0], 1)),
    ...mirrored(mirrored([line([12, 6, 6], [12, 6, 10])], 0, HALF_BED), 1, HALF_BED),
  ];
}

function printerSpool(centre) {
  const disc = [...hexagon(centre, 8, 1), ...spokes(centre, 8, 1)];
  return copied(disc, [
    [0, -4, 0],
    [0, 4, 0],
  ]);
}

/** A desktop printer: a bed on rails, a portal, a carriage on two rods, and the spool above. */
export function printer() {
  return sketchOf('Printer', {
    bed: {
      colour: COLOUR.black,
      lines: [
        ...rungs([6, 6, 10], [30, 6, 10], along([0, 6, 0], 4)),
        ...rungs([6, 6, 10], [6, 30, 10], along([6, 0, 0], 4)),
      ],
    },
    head: {
      colour: COLOUR.red,
      lines: [
        ...box([14, 8, 24], [8, 6, 8]),
        line([18, 8, 24], [18, 14, 24]),
        line([18, 10, 24], [18, 10, 18]),
      ],
    },
    display: {
      colour: COLOUR.azure,
      lines: path([12, 0, 6], [12, 0, 12], [24, 0, 12], [24, 0, 6]),
    },
    spool: { colour: COLOUR.red, lines: printerSpool([18, 18, 60]) },
    holder: {
      colour: COLOUR.orange,
      lines: [
        line([18, 14, 60], [18, 22, 60]),
        ...rungs([18, 14, 48], [18, 14, 60], along([0, 8, 0], 1)),
      ],
    },
    rods: {
      colour: COLOUR.grey,
      lines: [line([0, 14, 24], [36, 14, 24]), line([0, 14, 32], [36, 14, 32])],
    },
    portal: { colour: COLOUR.orange, lines: printerPortal() },
    base: { colour: COLOUR.darkGrey, lines: printerBase() },
  });
}

/** A pen plotter: a flat frame, a bridge across it, and a carriage with a pen. */
export function plotter() {
  return sketchOf('Plotter frame', {
    pen: { colour: COLOUR.red, lines: [line([16, 8, 2], [16, 8, 16])] },
    carriage: {
      colour: COLOUR.yellow,
      lines: [line([16, 8, 12], [16, 16, 12]), line([16, 8, 16], [16, 16, 16])],
    },
    bridge: {
      colour: COLOUR.grey,
      lines: [
        ...mirrored([...path([0, 12, 4], [0, 12, 16]), ...path([0, 16, 4], [0, 16, 16])], 0, 20),
        line([0, 12, 12], [40, 12, 12]),
        line([0, 16, 16], [40, 16, 16]),
        line([0, 12, 16], [40, 12, 16]),
        line([0, 16, 12], [40, 16, 12]),
        ...rungs(
          [0, 12, 16],
          [0, 16, 16],
          [
            [0, 0, 0],
            [40, 0, 0],
          ],
        ),
      ],
    },
    paper: {
      colour: COLOUR.white,
      lines: rungs([4, 0, 4], [4, 32, 4], along([8, 0, 0], 4)),
    },
    frame: {
      colour: COLOUR.blue,
      lines: [
        ...rectangle([0, 0, 4], [40, 32]),
        ...posts([0, 0, 0], [40, 32, 4]),
        ...rectangle([0, 0, 0], [40, 32]),
        ...mirrored(
          rungs(
            [0, 12, 0],
            [0, 12, 4],
            [
              [0, 0, 0],
              [0, 4, 0],
            ],
          ),
          0,
          20,
        ),
      ],
    },
  });
}
