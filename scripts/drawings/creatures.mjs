// What walks, and what grows, in the gallery.
import { box, line, path } from '../lib/families/shapes.mjs';
import { along, COLOUR, corners, hexagon, mirrored, rungs, sketchOf, spokes } from './pen.mjs';

/** A long-necked dinosaur: two sides for the body, neck and tail between them. */
export function dinosaur() {
  const side = [
    line([0, -4, 0], [0, -4, 20]),
    line([16, -4, 0], [16, -4, 20]),
    line([0, -4, 12], [16, -4, 12]),
    line([0, -4, 20], [16, -4, 20]),
    ...path([0, -4, 20], [8, -4, 26], [16, -4, 20]),
    line([8, -4, 12], [8, -4, 26]),
  ];
  const neck = [0, 1, 2].flatMap((k) => {
    const [x, z] = [-6 * k, 12 + 8 * k];
    return [
      line([x, 0, z], [x - 6, 0, z + 8]),
      line([x, 0, z + 8], [x - 6, 0, z + 16]),
      line([x, 0, z + 8], [x - 6, 0, z + 8]),
      line([x - 6, 0, z + 8], [x - 6, 0, z + 16]),
    ];
  });
  return sketchOf('Dinosaur', {
    ground: {
      colour: COLOUR.tan,
      lines: [
        ...mirrored([line([-6, -4, 0], [22, -4, 0])], 1),
        ...rungs([-6, -4, 0], [-6, 4, 0], along([28, 0, 0], 1)),
      ],
    },
    head: {
      colour: COLOUR.lime,
      lines: path([-18, 0, 44], [-28, 0, 44], [-28, 0, 40], [-18, 0, 40]),
    },
    neck: { colour: COLOUR.green, lines: neck },
    tail: {
      colour: COLOUR.green,
      lines: [line([16, 0, 20], [32, 0, 8]), line([16, 0, 14], [24, 0, 14])],
    },
    body: {
      colour: COLOUR.green,
      lines: [
        ...mirrored(side, 1),
        ...[
          [0, 12],
          [16, 12],
          [0, 20],
          [16, 20],
          [8, 26],
          [16, 14],
        ].map(([x, z]) => line([x, -4, z], [x, 4, z])),
        line([0, 0, 12], [0, 0, 20]),
      ],
    },
  });
}

/** A robot that stands, with arms that turn at shoulders and elbows. */
export function robot() {
  const arm = {
    upper: [line([-14, 4, 34], [-14, 4, 24])],
    lower: [line([-14, 4, 24], [-14, 4, 16]), line([-16, 4, 16], [-12, 4, 16])],
  };
  const right = (lines) => mirrored(lines, 0).slice(lines.length);
  const leg = [
    line([-4, 0, 0], [-4, 0, 20]),
    line([-4, 8, 0], [-4, 8, 20]),
    line([-4, 0, 10], [-4, 8, 10]),
  ];
  return sketchOf(
    'Robot',
    {
      'left hand': { colour: COLOUR.grey, lines: arm.lower },
      'right hand': { colour: COLOUR.grey, lines: right(arm.lower) },
      'left arm': { colour: COLOUR.blue, lines: arm.upper },
      'right arm': { colour: COLOUR.blue, lines: right(arm.upper) },
      shoulders: { colour: COLOUR.darkGrey, lines: [line([-14, 4, 34], [14, 4, 34])] },
      head: {
        colour: COLOUR.yellow,
        lines: [
          ...box([-4, 0, 38], [8, 8, 8]),
          line([-4, 4, 38], [4, 4, 38]),
          ...mirrored([line([-2, 4, 34], [-2, 4, 38])], 0),
        ],
      },
      antenna: {
        colour: COLOUR.red,
        lines: [line([-4, 4, 46], [4, 4, 46]), line([0, 4, 46], [0, 4, 52])],
      },
      body: {
        colour: COLOUR.blue,
        lines: [
          ...box([-6, 0, 20], [12, 8, 14]),
          ...mirrored([line([-4, 0, 20], [-4, 8, 20])], 0),
          line([-6, 0, 28], [6, 0, 28]),
        ],
      },
      legs: { colour: COLOUR.darkGrey, lines: mirrored(leg, 0) },
      feet: {
        colour: COLOUR.red,
        lines: mirrored(
          [
            line([-4, -6, 0], [-4, 8, 0]),
            line([-8, -6, 0], [-2, -6, 0]),
            line([-8, 8, 0], [-2, 8, 0]),
          ],
          0,
        ),
      },
    },
    [-1, 1].flatMap((side) => {
      const name = side < 0 ? 'left' : 'right';
      return [
        { at: [14 * side, 4, 34], axis: [0, 1, 0], between: [['shoulders'], [`${name} arm`]] },
        { at: [14 * side, 4, 24], axis: [0, 1, 0], between: [[`${name} arm`], [`${name} hand`]] },
      ];
    }),
  );
}

/** A robot on four legs, each with a hip and a knee. */
export function walkingRobot() {
  const parts = {};
  const joints = [];
  for (const [place, x] of [
    ['front', 6],
    ['back', 26],
  ]) {
    for (const [side, y] of [
      ['left', -6],
      ['right', 6],
    ]) {
      const thigh = `${place} ${side} thigh`;
      const shin = `${place} ${side} shin`;
      parts[thigh] = { colour: COLOUR.orange, lines: [line([x, y, 16], [x + 6, y, 8])] };
      parts[shin] = { colour: COLOUR.black, lines: [line([x + 6, y, 8], [x, y, 0])] };
      joints.push({ at: [x, y, 16], axis: [0, 1, 0], between: [['body'], [thigh]] });
      joints.push({ at: [x + 6, y, 8], axis: [0, 1, 0], between: [[thigh], [shin]] });
    }
  }
  const side = [
    line([0, -6, 16], [28, -6, 16]),
    line([4, -6, 22], [28, -6, 22]),
    line([4, -6, 16], [4, -6, 22]),
    line([12, -6, 16], [12, -6, 22]),
    line([20, -6, 16], [20, -6, 22]),
    line([28, -6, 16], [28, -6, 22]),
    line([4, -6, 16], [12, -6, 22]),
    line([28, -6, 16], [20, -6, 22]),
  ];
  return sketchOf(
    'Walking robot',
    {
      ...parts,
      head: {
        colour: COLOUR.azure,
        lines: [...box([-12, -4, 20], [8, 8, 6]), line([-12, 0, 20], [4, 0, 20])],
      },
      body: {
        colour: COLOUR.yellow,
        lines: [
          ...mirrored(side, 1),
          ...rungs([4, -6, 16], [4, 6, 16], along([8, 0, 0], 3)),
          ...rungs([4, -6, 22], [4, 6, 22], along([8, 0, 0], 3)),
          line([4, -6, 20], [4, 6, 20]),
        ],
      },
    },
    joints,
  );
}

/** Two strands that climb round a hexagon, corner by corner, with rungs across. */
export function helix() {
  const steps = 12;
  const rise = 4;
  const at = (k) => corners([0, 0, rise * k], 6, 2);
  const strand = (turn) =>
    Array.from({ length: steps }, (_, k) => {
      const a = (k + turn) % 6;
      const b = (k + 1 + turn) % 6;
      return path(at(k)[a], at(k)[b], at(k + 1)[b]);
    }).flat();
  const rung = (k) => line(at(k)[k % 6], at(k)[(k + 3) % 6]);
  const numbers = Array.from({ length: steps + 1 }, (_, k) => k);
  return sketchOf('DNA helix', {
    'first rungs': { colour: COLOUR.yellow, lines: numbers.filter((k) => k % 2 === 0).map(rung) },
    'second rungs': { colour: COLOUR.lime, lines: numbers.filter((k) => k % 2 === 1).map(rung) },
    'first strand': { colour: COLOUR.red, lines: strand(0) },
    'second strand': { colour: COLOUR.blue, lines: strand(3) },
    foot: {
      colour: COLOUR.darkGrey,
      lines: [...hexagon([0, 0, 0], 6, 2), ...spokes([0, 0, 0], 6, 2)],
    },
  });
}
