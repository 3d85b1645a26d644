// A model file moved as a rigid body, its sketch with it.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { TOP } from './run.mjs';

const catalogue = JSON.parse(readFileSync(resolve(TOP, 'core/parts/catalogue.json'), 'utf8'));
const holeAxes = new Map(catalogue.parts.map(({ id, solid }) => [id, solid[0]?.axis]));

/** Layers count along the hole axis, whichever way of it adds up to more than 0. */
function layerOf({ part, rotation, layer }, rotationAfter) {
  const axis = holeAxes.get(part);
  const way = (m) => (axis && turned(m, axis).reduce((sum, x) => sum + x, 0) < 0 ? -1 : 1);
  return layer * way(rotation) * way(rotationAfter) + 0;
}

const neat = (value) => Math.round(value * 1e9) / 1e9 + 0;
const turned = (m, v) =>
  [0, 3, 6].map((i) => neat(m[i] * v[0] + m[i + 1] * v[1] + m[i + 2] * v[2]));
const times = (m, n) =>
  [0, 3, 6].flatMap((i) =>
    [0, 1, 2].map((k) => neat(m[i] * n[k] + m[i + 1] * n[k + 3] + m[i + 2] * n[k + 6])),
  );

/** @param {{ turn: number[], shift: number[] }} motion */
export function movedModel(model, { turn, shift }) {
  const place = (p) => turned(turn, p).map((x, i) => neat(x + shift[i]));
  const letter = (axis) =>
    'xyz'[
      turned(
        turn,
        ['x', 'y', 'z'].map((l) => +(l === axis)),
      ).findIndex(Boolean)
    ];
  const line = (one) => ({
    ...one,
    from: place(one.from),
    to: place(one.to),
    ...(one.holeAxis && { holeAxis: letter(one.holeAxis) }),
  });
  const box = ({ min, max }) => {
    const [a, b] = [place(min), place(max)];
    return { min: a.map((x, i) => Math.min(x, b[i])), max: a.map((x, i) => Math.max(x, b[i])) };
  };
  const { sketch } = model;
  const { symmetries: _, ...rest } = sketch;
  return {
    ...model,
    parts: model.parts.map((part) => {
      const rotation = times(turn, part.rotation);
      return { ...part, position: place(part.position), rotation, layer: layerOf(part, rotation) };
    }),
    sketch: {
      ...rest,
      lines: sketch.lines.map(line),
      ...(sketch.joints && {
        joints: sketch.joints.map((j) => ({ ...j, at: place(j.at), axis: turned(turn, j.axis) })),
      }),
      ...(sketch.keepOut && { keepOut: sketch.keepOut.map(box) }),
      ...(sketch.ground !== undefined && { ground: neat(sketch.ground + shift[2]) }),
    },
  };
}
