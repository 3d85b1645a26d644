// What the public facts do not hold about our parts: class, colour, friction, measured mass and the
// simplified solid. Lengths are LDU in LDraw's own frame (20 LDU = 1 module, -Y up).
// A body or a neck (between the body and a head) is a list of stadium prisms
// [from, to, axis, radius, halfThickness]; the tubes around holes and the arms of beams are made from the
// facts. Middle lines of bodies lie on whole cells wherever the part does: the search takes its cells from
// them. tests/core/parts holds all of it against the voxels of the real parts.

const X = [1, 0, 0];
const Y = [0, 1, 0];
const Z = [0, 0, 1];
const O = [0, 0, 0];

/** g/cm3. */
export const ABS_DENSITY = 1.05;
/** g/cm3 of LDraw's volume; mean over the three weighed beams 32316, 40490 and 32278. */
export const STRAIGHT_BEAM_DENSITY = 1.162;
/** g/cm3 of LDraw's volume; a plain axle then weighs the middle of the published 0.10 to 0.16 g a module. */
export const AXLE_DENSITY = 1.322;
/** For masses that are not what the volume would weigh: why they are believed all the same. */
const WEIGHED =
  "scales, as the facts beside the project tell; LDraw's mesh of it is open, so its volume is too small";

// LDraw colours.
const BLACK = 0;
const BLUE = 1;
const RED = 4;
const TAN = 19;
const LIGHT = 71;
const DARK = 72;

const beam = (holes, more = {}) => ({ class: 'beam', color: LIGHT, holes, ...more });
const bent = (arms, more = {}) => ({ class: 'beam', color: DARK, arms, ...more });
const pin = (color, more = {}) => ({ class: 'pin', color, ...more });
const frictionPin = (color, more = {}) => pin(color, { friction: true, ...more });
const axle = (color, more = {}) => ({ class: 'axle', color, ...more });
const connector = (color, body = [], more = {}) => ({ class: 'connector', color, body, ...more });
const gear = (color, radius, halfThickness, center = O) => ({
  class: 'gear',
  color,
  body: [[center, center, Z, radius, halfThickness]],
});

const disc = (center, axis, radius, halfThickness) => [center, center, axis, radius, halfThickness];

// Collar and web of a pin that grows out of a perpendicular tube.
const PIN_ROOT = 8;

const BEAMS = {
  18654: beam(1),
  43857: beam(2),
  32523: beam(3),
  32316: beam(5, { mass: 1.34 }),
  32524: beam(7),
  40490: beam(9, { mass: 2.58 }),
  32525: beam(11),
  41239: beam(13),
  32278: beam(15, { mass: 4.27 }),
  6632: beam(3),
  32449: beam(4),
  32017: beam(5),
  32063: beam(6),
  32065: beam(7),
  // Same length and thickness as another beam, but with cross holes: not a plain straight beam.
  60483: beam(0),
  11478: beam(0),
  32056: bent([
    [
      [40, 0],
      [0, 0],
      [0, 40],
    ],
  ]),
  32140: bent([
    [
      [0, 0],
      [0, 60],
      [20, 60],
    ],
  ]),
  32526: bent([
    [
      [0, 0],
      [0, 80],
      [40, 80],
    ],
  ]),
  60484: bent([
    [
      [0, 0],
      [0, 40],
    ],
    [
      [-20, 40],
      [20, 40],
    ],
  ]),
  32348: bent([
    [
      [0, 0],
      [0, 60],
      [48, 96],
    ],
  ]),
  32271: bent([
    [
      [0, 0],
      [0, 120],
      [32, 144],
    ],
  ]),
  6629: bent([
    [
      [0, 0],
      [0, 100],
      [48, 136],
    ],
  ]),
  32009: bent([
    [
      [0, -160],
      [0, -40],
      [40, 0],
      [80, 0],
    ],
  ]),
  14720: bent(
    [
      [
        [0, -40],
        [0, 40],
      ],
      [
        [-20, -40],
        [20, -40],
      ],
      [
        [-20, 40],
        [20, 40],
      ],
    ],
    { color: LIGHT },
  ),
  64179: bent(
    [
      [
        [-40, -60],
        [40, -60],
        [40, 60],
        [-40, 60],
        [-40, -60],
      ],
    ],
    { color: LIGHT, armRadius: 10 },
  ),
  64178: bent(
    [
      [
        [-40, -100],
        [-40, 100],
      ],
      [
        [40, -100],
        [40, 100],
      ],
      [
        [-40, -60],
        [40, -60],
      ],
      [
        [-40, 60],
        [40, 60],
      ],
    ],
    { color: LIGHT, armRadius: 10 },
  ),
};

const PINS = {
  2780: frictionPin(BLACK, { mass: 0.2 }),
  3673: pin(LIGHT),
  6558: frictionPin(BLUE, { mass: 0.29 }),
  32556: pin(TAN),
  // Published: 0.11 to 0.19; its volume in ABS is 0.20.
  43093: frictionPin(BLUE, { mass: 0.19, massEstimated: true }),
  3749: pin(TAN),
  11214: frictionPin(BLACK),
  18651: frictionPin(BLACK),
  65249: pin(TAN),
  32054: frictionPin(RED),
  87082: frictionPin(LIGHT, { mass: 0.35, body: [disc(O, X, PIN_ROOT, 10)] }),
  44874: frictionPin(LIGHT, { body: [disc(O, X, PIN_ROOT, 10)] }),
  15100: frictionPin(BLACK, { mass: 0.26, neck: [disc([6.5, 0, 0], X, PIN_ROOT, 3.5)] }),
  32138: frictionPin(LIGHT, {
    body: [
      [[0, -10, 0], [0, 10, 0], X, 9, 10],
      [[0, -10, 0], [0, 10, 0], Z, 9, 9],
    ],
  }),
};

const AXLES = {
  32062: axle(RED),
  3704: axle(BLACK),
  4519: axle(LIGHT),
  3705: axle(BLACK),
  32073: axle(LIGHT),
  3706: axle(BLACK),
  44294: axle(LIGHT),
  3707: axle(BLACK),
  60485: axle(LIGHT),
  3737: axle(BLACK),
  23948: axle(LIGHT),
  3708: axle(BLACK),
  24316: axle(TAN),
  87083: axle(DARK),
  15462: axle(DARK),
  55013: axle(DARK),
};

const BUSHES = {
  3713: { class: 'bush', color: LIGHT, mass: 0.14 },
  '32123b': { class: 'bush', color: LIGHT },
};

/** What joins a head or an axle hole to the middle tube of its part; a neck, so that it has no back. */
const stump = (direction) =>
  disc(
    direction.map((value) => 6.5 * value),
    direction,
    8.5,
    3.5,
  );

/** The arm of an angle connector that leaves the pin hole at the given place of its axle hole. */
const angled = (y, z) => stump([0, y / 20, z / 20]);

const CONNECTORS = {
  55615: connector(LIGHT, [
    [O, [0, -40, 0], X, 9, 10],
    [O, [0, -40, 0], Z, 9, 10],
    [O, [0, 0, 40], X, 9, 10],
    [O, [0, 0, 40], Y, 9, 10],
  ]),
  48989: connector(
    LIGHT,
    [
      [[0, -20, 0], [0, 20, 0], X, 9, 10],
      [[0, -20, 0], [0, 20, 0], Z, 9, 10],
    ],
    { mass: 0.95 },
  ),
  6536: connector(DARK, [[O, [0, 20, 0], X, 9, 9]], { mass: 0.54, massSource: WEIGHED }),
  32184: connector(DARK, [[[0, -20, 0], [0, 20, 0], X, 9, 9]], {
    mass: 0.91,
    massSource: WEIGHED,
  }),
  42003: connector(DARK, [
    [[0, -20, 0], [0, 20, 0], X, 9, 9],
    [O, [0, 20, 0], Z, 9, 10],
  ]),
  32291: connector(DARK, [
    [[-10, 20, 0], [10, 20, 0], Z, 9, 10],
    [O, [0, 20, 0], X, 9, 9],
  ]),
  63869: connector(LIGHT, [
    [[-20, 20, 0], [20, 20, 0], Z, 9, 10],
    [O, [0, 20, 0], X, 9, 10],
  ]),
  41678: connector(DARK, [
    [[-15, 0, 0], [-15, 0, -20], X, 9.7, 5],
    [[15, 0, 0], [15, 0, -20], X, 9.7, 5],
    [[-10, 0, -20], [10, 0, -20], Y, 9.9, 10],
    disc([-5, 0, -17.5], Y, 9.4, 10),
    disc([5, 0, -17.5], Y, 9.4, 10),
  ]),
  22961: connector(DARK, [], { neck: [stump([1, 0, 0])] }),
  10197: connector(DARK, [], { neck: [stump([0, -1, 0]), stump([0, 0, -1])] }),
  27940: connector(DARK, [disc(O, X, 8.5, 10)]),
  44809: connector(RED, [
    [O, [0, 0, -20], Y, 9, 10],
    [O, [20, 0, 0], Y, 9, 9],
    [O, [20, 0, 0], Z, 9, 9],
  ]),
  32013: connector(DARK, [], { neck: [stump([0, 0, -1])] }),
  32034: connector(DARK, [disc(O, Z, 8.5, 10)]),
  32016: connector(DARK, [], { neck: [stump([0, 0, -1]), angled(-7.653669, 18.477591)] }),
  32192: connector(DARK, [], { neck: [stump([0, 0, -1]), angled(-14.142136, 14.142136)] }),
  32015: connector(DARK, [], { neck: [stump([0, 0, -1]), angled(-18.477591, 7.653669)] }),
  32014: connector(DARK, [], { neck: [stump([0, 0, -1]), stump([0, -1, 0])] }),
  39793: connector(LIGHT, [
    [[-20, 0, -20], [-20, 0, 20], Y, 9.7, 10],
    [[20, 0, -20], [20, 0, 20], Y, 9.7, 10],
    [[-20, 0, 0], [20, 0, 0], Y, 9, 10],
    [[0, 0, -20], [0, 0, 20], Y, 9, 10],
    disc([0, 0, 20], X, 8, 30),
    disc([0, 0, -20], X, 8, 30),
  ]),
  32039: connector(DARK, [[O, [0, 0, -20], X, 9, 9]]),
  62462: connector(LIGHT),
  75535: connector(LIGHT, [], { tubeRadius: 10 }),
  59443: connector(DARK),
};

// Tip radii: two gears in mesh overlap by two addenda (analysis/collisions knows).
const GEARS = {
  10928: gear(DARK, 12.43, 10),
  94925: gear(LIGHT, 21.64, 10),
  '3648b': gear(DARK, 32.39, 9.625),
  3649: gear(LIGHT, 52.35, 10),
  6589: gear(TAN, 16, 5, [0, 0, 2]),
  32270: gear(BLACK, 17, 10),
  32269: gear(BLACK, 27, 10),
  46372: gear(DARK, 36.802, 10),
  32498: gear(BLACK, 47, 10),
  // A pulley, which serves as a wheel.
  3736: gear(LIGHT, 46.7, 10),
};

export const PARTS = { ...BEAMS, ...PINS, ...AXLES, ...BUSHES, ...CONNECTORS, ...GEARS };
