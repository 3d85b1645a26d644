// What the gallery's drawings are drawn with: lines as pairs of points in modules, z up; colours in LDraw codes.
import { add, line, loop } from '../lib/families/shapes.mjs';

export const COLOUR = {
  black: 0,
  blue: 1,
  green: 2,
  red: 4,
  yellow: 14,
  white: 15,
  tan: 19,
  orange: 25,
  lime: 27,
  brown: 70,
  grey: 71,
  darkGrey: 72,
  azure: 322,
  darkRed: 320,
};

/** Half the square root of three: the height of a triangle with sides of one. */
const HIGH = Math.sqrt(0.75);

/** Lines and their image in the plane where coordinate `axis` (0 to 2) is `at`. */
export function mirrored(lines, axis, at = 0) {
  const image = (point) => point.map((x, i) => (i === axis ? 2 * at - x : x));
  return [...lines, ...lines.map(([from, to]) => [image(from), image(to)])];
}

/** Lines and their copies, moved by each of `offsets`. */
export function copied(lines, offsets) {
  return offsets.flatMap((by) => lines.map(([from, to]) => [add(from, by), add(to, by)]));
}

/** Parallel lines from a to b, moved by each of `offsets`. */
export function rungs(a, b, offsets) {
  return copied([line(a, b)], offsets);
}

/** Offsets 0, step, 2 step up to n steps. */
export function along(step, n) {
  return Array.from({ length: n + 1 }, (_, i) => step.map((x) => i * x));
}

/** The six corners of a hexagon across axis `across`, the first along the first axis that is left. */
export function corners(centre, radius, across = 1) {
  const half = radius / 2;
  const high = radius * HIGH;
  const flat = [
    [radius, 0],
    [half, high],
    [-half, high],
    [-radius, 0],
    [-half, -high],
    [half, -high],
  ];
  return flat.map((offset) => {
    const by = [...offset];
    by.splice(across, 0, 0);
    return add(centre, by);
  });
}

export const hexagon = (centre, radius, across) => loop(...corners(centre, radius, across));

/** The three lines through a hexagon's middle. */
export function spokes(centre, radius, across) {
  const at = corners(centre, radius, across);
  return [0, 1, 2].map((i) => line(at[i], at[i + 3]));
}

/** How high the middle of a hexagonal wheel on the ground is. */
export const wheelHeight = (radius) => radius * HIGH;

const rounded = (x) => Math.round(x * 1e6) / 1e6 + 0;

function onSegment(point, [from, to]) {
  const d = to.map((x, i) => x - from[i]);
  const p = point.map((x, i) => x - from[i]);
  const length = Math.hypot(...d);
  const t = p.reduce((sum, x, i) => sum + x * d[i], 0) / length;
  const off = Math.hypot(...p.map((x, i) => x - (t * d[i]) / length));
  return off < 1e-6 && t > -1e-6 && t < length + 1e-6;
}

/**
 * A sketch of version 2.
 * @param parts by name: colour and lines; a line that two of them have belongs to the first
 * @param joints `{ at, axis, between: [names, names], range? }`: of each named part those lines turn that reach the joint
 */
export function sketchOf(name, parts, joints = []) {
  const known = new Map();
  const owners = [];
  for (const [owner, { lines }] of Object.entries(parts)) {
    for (const points of lines) {
      const [from, to] = points.map((point) => point.map(rounded));
      const key = [from, to].map(String).sort().join(' to ');
      if (!known.has(key)) {
        known.set(key, { from, to });
        owners.push(owner);
      }
    }
  }
  const lines = [...known.values()];
  const reaching = (names, at) =>
    owners.flatMap((owner, i) =>
      names.includes(owner) && onSegment(at, [lines[i].from, lines[i].to]) ? [i] : [],
    );
  return {
    format: 'technic-sketch',
    version: 2,
    name,
    lines,
    ...(joints.length > 0 && {
      joints: joints.map(({ at, between, ...rest }) => ({
        at: at.map(rounded),
        ...rest,
        between: between.map((names) => reaching(names, at)),
      })),
    }),
    colours: { lines: Object.fromEntries(owners.map((owner, i) => [i, parts[owner].colour])) },
  };
}

/** The text of a sketch, a line of the drawing a line of the file. */
export function sketchText(sketch) {
  const members = Object.entries(sketch).map(([key, value]) => {
    const rows = Array.isArray(value) ? value.map((row) => `    ${JSON.stringify(row)}`) : null;
    return `  ${JSON.stringify(key)}: ${rows ? `[\n${rows.join(',\n')}\n  ]` : JSON.stringify(value)}`;
  });
  return `{\n${members.join(',\n')}\n}\n`;
}
