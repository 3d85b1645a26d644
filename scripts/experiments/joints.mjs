import { mkdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { line, path, posts, rectangle } from '../lib/families/shapes.mjs';
import { drawParts } from '../lib/gallery.mjs';
import { loadTypeScript } from '../lib/load-typescript.mjs';
import { yesNo } from './laboratory.mjs';

const PICTURE = {
  size: { width: 320, height: 240, margin: 12 },
  colours: 64,
  style: { detail: 'high', smooth: 3, line: 0.34 },
};
const TITLES = ['joint', 'beams', 'bricks', 'joints that turn', 'loose', 'hole axis', 'buildable'];

/** A chair whose back, a post with a bar, turns at the middle of the seat's rear edge. */
function chair(name, axis) {
  const seat = [...posts([0, 0, 0], [8, 8, 6]), ...rectangle([0, 0, 6], [8, 8])];
  const back = [...path([4, 8, 6], [4, 8, 14]), line([1, 8, 14], [7, 8, 14])];
  const lines = [...seat, ...back].map(([from, to]) => ({ from, to }));
  const rear = seat.findIndex(([from, to]) => from[1] === 8 && to[1] === 8 && from[2] === to[2]);
  const joints = axis === null ? [] : [{ at: [4, 8, 6], axis, between: [[rear], [seat.length]] }];
  return { format: 'technic-sketch', version: 1, name, lines, joints };
}

const CHAIRS = [
  ['none', null],
  ['about the rear edge (leans)', [1, 0, 0]],
  ['across the rear edge (tilts)', [0, 1, 0]],
];

/** The principal axis that a direction in a part's frame has in the world. */
function worldAxis({ rotation }, direction) {
  const along = [0, 3, 6].map((row) =>
    Math.abs(direction.reduce((sum, x, k) => sum + x * rotation[row + k], 0)),
  );
  return ['x', 'y', 'z'][along.indexOf(Math.max(...along))];
}

/** Hole axis of a beam that lies upright along the back's post. */
function postAxis(laboratory, model) {
  for (const placed of model.parts) {
    const facts = laboratory.parts().get(placed.part);
    const [x, y, z] = placed.position;
    const there = Math.abs(x - 4) < 2.5 && Math.abs(y - 8) < 2.5 && z > 6 && z < 14;
    for (const { from, to } of facts?.class === 'beam' && there ? facts.stretches : []) {
      const along = to.map((t, i) => t - from[i]);
      if (Math.hypot(...along) > 3 && worldAxis(placed, along) === 'z') {
        return worldAxis(placed, facts.solid[0].axis);
      }
    }
  }
  return '-';
}

export const joints = {
  name: 'joints',
  title: 'Annotated joints: one chair, two axes',
  shows:
    'The same chair three times: without a joint, with its back turning about the rear edge of the seat, and with the joint across that edge. The joint’s axis decides how the holes lie, so the models differ.',
  differs: 'The chair is our own; in the paper two chairs with other lines are shown.',
  async run(laboratory, out) {
    const { tools } = await loadTypeScript('scripts/lib/gallery-tools.ts');
    mkdirSync(resolve(out, 'pictures'), { recursive: true });
    const found = CHAIRS.map(([joint, axis], i) => {
      const sketch = laboratory.fileOf(chair(`chair joint ${i}`, axis));
      const { report, model } = laboratory.solveModel(joint, sketch, []);
      drawParts(resolve(out, 'pictures', `chair-joint-${i}.png`), model.parts, tools, PICTURE);
      const turning = report.items.find(({ id }) => id === 'joints').detail;
      return [
        ...[joint, report.beams + report.axles, report.bricks, turning],
        ...[report.freedomsBeyondJoints, postAxis(laboratory, model), yesNo(report.buildable)],
      ];
    });
    const pictures = {
      titles: CHAIRS.map(([joint]) => joint),
      rows: [CHAIRS.map(([joint], i) => `![${joint}](pictures/chair-joint-${i}.png)`)],
    };
    return {
      tables: [pictures, { titles: TITLES, rows: found }],
      csv: { titles: TITLES, rows: found },
    };
  },
};
