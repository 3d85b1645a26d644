import { resolve } from 'node:path';
import { cubeSketch } from '../lib/families/families.mjs';
import { StepError, TOP } from '../lib/run.mjs';
import { settings, yesNo } from './laboratory.mjs';

const gallery = (name) => resolve(TOP, `public/gallery/${name}.sketch.json`);
const MOST_STEPS = 40;
const TITLES = ['model', 'taken out', 'then', 'beams', 'bricks', 'beams used', 'buildable'];

/** Numbers of parts with how often they are there, most used first; the lower number of equals. */
export function byUse(ids) {
  const counts = new Map();
  for (const id of ids) {
    counts.set(id, (counts.get(id) ?? 0) + 1);
  }
  return [...counts].sort(([a, n], [b, m]) => m - n || (a < b ? -1 : 1));
}

/** The reports of a sketch as its most used beam is taken out again and again. */
function takenOut(laboratory, name, sketch) {
  const out = [];
  const rows = [];
  for (let step = 0; step < MOST_STEPS; ++step) {
    let solved = null;
    const args = ['--preset', 'simple', ...settings(out.map((id) => `owned.${id}=0`))];
    try {
      solved = laboratory.solveModel(
        `${name}, without ${out.join(' ') || 'nothing'}`,
        sketch,
        args,
      );
    } catch (error) {
      if (!(error instanceof StepError)) {
        throw error;
      }
      rows.push([name, out.at(-1), 'no set of beams left', '-', '-', '-', 'no']);
      return rows;
    }
    const used = byUse(laboratory.beamsOf(solved.model));
    const { beams, bricks, buildable } = solved.report;
    const kinds = used.map(([id, count]) => `${count} x ${id}`).join(', ');
    rows.push([name, out.at(-1) ?? '-', `${step} out`, beams, bricks, kinds, yesNo(buildable)]);
    if (used.length === 0) {
      return rows;
    }
    out.push(used[0][0]);
  }
  return rows;
}

export const brickSets = {
  name: 'brick-sets',
  title: 'Robustness to brick sets',
  shows:
    'The beam that a model uses most is taken out of the brick set and the model made anew, again and again until no beam is left that could cover its lines: for the cube, as in the paper, and three others.',
  differs:
    'The paper’s set has 11 kinds of beams, ours more (bent ones of all angles, T, frames, thin ones), so there are more steps. Goal "simple layouts" as there.',
  run(laboratory) {
    const sketches = laboratory.some(
      [
        ['cube', laboratory.fileOf(cubeSketch(8))],
        ['flying-kite', gallery('flying-kite')],
        ['chair-front', gallery('chair-front')],
        ['tower-2d', gallery('small-tower-2d')],
      ],
      1,
    );
    const rows = sketches.flatMap(([name, sketch]) => takenOut(laboratory, name, sketch));
    return { tables: [{ titles: TITLES, rows }], csv: { titles: TITLES, rows } };
  },
};
