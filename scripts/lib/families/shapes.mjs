// What the families of sketches are drawn with: lines as pairs of points, whole numbers everywhere.

export const add = (a, b) => a.map((x, i) => x + b[i]);

export const line = (from, to) => [from, to];

/** Lines that follow points one after the other. */
export function path(...points) {
  return points.slice(1).map((to, i) => [points[i], to]);
}

/** A closed path. */
export function loop(...points) {
  return path(...points, points[0]);
}

export function shifted(lines, by) {
  return lines.map(([from, to]) => [add(from, by), add(to, by)]);
}

/** A rectangle in a plane of constant z, y or x; `across` names that axis, 0 to 2. */
export function rectangle(at, [u, v], across = 2) {
  const corner = (a, b) => {
    const offset = [a * u, b * v];
    offset.splice(across, 0, 0);
    return add(at, offset);
  };
  return loop(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
}

/** The twelve edges of a box. */
export function box(at, [w, d, h]) {
  return [
    ...rectangle(at, [w, d]),
    ...rectangle(add(at, [0, 0, h]), [w, d]),
    ...posts(at, [w, d, h]),
  ];
}

/** The four upright edges of a box. */
export function posts(at, [w, d, h]) {
  return [
    [0, 0],
    [w, 0],
    [w, d],
    [0, d],
  ].map(([x, y]) => line(add(at, [x, y, 0]), add(at, [x, y, h])));
}

/** n by m cells in a plane of constant z, as lines from side to side. */
export function grid(at, [n, m], cell) {
  const lines = [];
  for (let i = 0; i <= m; ++i) {
    lines.push(line(add(at, [0, i * cell, 0]), add(at, [n * cell, i * cell, 0])));
  }
  for (let i = 0; i <= n; ++i) {
    lines.push(line(add(at, [i * cell, 0, 0]), add(at, [i * cell, m * cell, 0])));
  }
  return lines;
}

/** A flat truss of 3-4-5 (or 6-8-10) bays from x = 0 on in a plane of constant y. */
export function truss(y, bays, scale) {
  const [w, h] = [4 * scale, 3 * scale];
  const lines = [line([0, y, 0], [bays * w, y, 0]), line([0, y, h], [bays * w, y, h])];
  for (let i = 0; i <= bays; ++i) {
    lines.push(line([i * w, y, 0], [i * w, y, h]));
  }
  for (let i = 0; i < bays; ++i) {
    const rising = i < bays / 2;
    lines.push(
      rising ? line([i * w, y, 0], [(i + 1) * w, y, h]) : line([i * w, y, h], [(i + 1) * w, y, 0]),
    );
  }
  return lines;
}

/** Sketch lines without those that are there twice. */
export function unique(lines) {
  const seen = new Set();
  return lines.filter(([from, to]) => {
    const ends = [from, to].map((p) => p.map((x) => x.toFixed(6)).join()).sort();
    const key = ends.join(' ');
    const fresh = !seen.has(key);
    seen.add(key);
    return fresh && ends[0] !== ends[1];
  });
}
