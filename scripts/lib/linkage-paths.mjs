// Fifty paths for `npm run linkages`: twenty that people draw (letters as single strokes, feet, straight
// lines, ellipses), thirty curves of four-bars whose lengths are no whole numbers. Modules, in the plane.
import { random } from './random-sketches.mjs';

const arc = ([u, v], radius, [from, to], count = 24) =>
  Array.from({ length: count + 1 }, (_, i) => {
    const angle = ((from + ((to - from) * i) / count) * Math.PI) / 180;
    return [u + radius * Math.cos(angle), v + radius * Math.sin(angle)];
  });

const LETTERS = {
  C: { closed: false, points: arc([0, 0], 2.5, [50, 310]) },
  D: { closed: true, points: [[0, 0], [0, 5], ...arc([0, 2.5], 2.5, [90, -90])] },
  I: {
    closed: false,
    points: [
      [0, 0],
      [0, 5],
    ],
  },
  J: { closed: false, points: [[2, 5], ...arc([0.5, 1.5], 1.5, [0, -180])] },
  L: {
    closed: false,
    points: [
      [0, 5],
      [0, 0],
      [3, 0],
    ],
  },
  O: {
    closed: true,
    points: arc([0, 0], 1, [0, 360])
      .map(([u, v]) => [2 * u, 3 * v])
      .slice(0, -1),
  },
  S: {
    closed: false,
    points: [...arc([0, 3.5], 1.5, [30, 270]), ...arc([0, 0.5], 1.5, [90, -150])],
  },
  U: { closed: false, points: [[-1.5, 5], ...arc([0, 1.5], 1.5, [180, 360]), [1.5, 5]] },
  V: {
    closed: false,
    points: [
      [-1.75, 5],
      [0, 0],
      [1.75, 5],
    ],
  },
};

const foot = (length, lift) => ({
  kind: 'foot',
  closed: true,
  points: arc([0, 0], 1, [0, 180]).map(([u, v]) => [(length / 2) * u, lift * v]),
});

const ellipse = (a, b) => ({
  closed: true,
  points: arc([0, 0], 1, [0, 360], 48)
    .map(([u, v]) => [a * u, b * v])
    .slice(0, -1),
});

const line = (length, degrees) => {
  const [[u, v]] = arc([0, 0], length, [degrees, degrees], 1);
  return {
    kind: 'line',
    closed: false,
    points: [
      [0, 0],
      [u, v],
    ],
  };
};

/** The curve of a random crank-rocker, or null where the links make none with a fair push. */
function couplerCurve(rng) {
  const between = (low, high) => rng.whole(low * 1000, high * 1000) / 1000;
  const [a, b, c, d] = [between(1, 4), between(3, 10), between(3, 10), between(3, 11)];
  const [x, y] = [between(-4, 10), between(-5, 5)];
  const worst = Math.max(
    ...[d - a, d + a].map((far) => Math.abs(b * b + c * c - far * far) / (2 * b * c)),
  );
  if (
    a + Math.max(b, c, d) >= b + c + d - Math.max(b, c, d) ||
    a >= Math.min(b, c, d) ||
    worst > 0.86
  ) {
    return null;
  }
  const points = arc([0, 0], a, [0, 360], 72)
    .slice(0, -1)
    .map(([u, v]) => {
      const far = Math.hypot(d - u, v);
      const along = (b * b - c * c + far * far) / (2 * far);
      const across = Math.sqrt(b * b - along * along);
      const [p, q] = [(d - u) / far, -v / far];
      const [e, f] = [(p * along - q * across) / b, (q * along + p * across) / b];
      return [u + e * x - f * y, v + f * x + e * y];
    });
  return { closed: true, points };
}

/** @returns {{name: string, kind: string, closed: boolean, points: number[][]}[]} */
export function linkagePaths(seed = 1) {
  const drawn = [
    ...Object.entries(LETTERS).map(([name, path]) => ({ name: `letter ${name}`, ...path })),
    ...[
      [4, 1.2],
      [5, 1.5],
      [6, 2],
      [8, 2.4],
    ].map(([l, h]) => ({ name: `foot ${l}`, ...foot(l, h) })),
    ...[
      [4, 0],
      [7, 0],
      [9, 30],
    ].map(([l, a]) => ({ name: `line ${l}`, ...line(l, a) })),
    ...[
      [2, 1],
      [3, 2],
      [4, 1.5],
      [3, 0.5],
    ].map(([a, b]) => ({
      name: `ellipse ${a} ${b}`,
      ...ellipse(a, b),
    })),
  ];
  const rng = random(seed);
  const curves = [];
  while (curves.length < 30) {
    const curve = couplerCurve(rng);
    if (curve) {
      curves.push({ name: `coupler ${curves.length + 1}`, ...curve });
    }
  }
  return [...drawn, ...curves].map((path) => ({ kind: 'any', ...path }));
}

/** The path file of a path in the plane of X and Z. */
export function pathText({ kind, closed, points }) {
  return JSON.stringify({
    format: 'technic-path',
    version: 1,
    kind,
    closed,
    points: points.map(([u, v]) => [u, 0, v]),
  });
}
