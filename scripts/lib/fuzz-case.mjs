// One case of `npm run fuzz`: what must hold of any sketch, whichever door (fuzz-doors.mjs) answers.
import { fuzzCase, rigidMotion } from './fuzz-cases.mjs';
import { movedModel } from './fuzz-motion.mjs';
import { compareLink, compareMpd } from './fuzz-round-trips.mjs';

const ANGLE = 0.5; // degrees between two ranges of one joint
const CANCEL_EVERY = 10; // cases: one is given up first
const MOST_STEPS = 4; // before it is

const itemsOf = (report) => report.items.map(({ id, ok }) => `${id} ${ok}`).join(', ');

/** What two reports on one model must agree in. */
function verdictOf(report) {
  return `${itemsOf(report)}, collisions ${report.collisions}, uncovered ${report.uncovered}`;
}

function sameJoints(a, b) {
  return (a.joints ?? []).every((joint, i) => {
    const other = b.joints?.[i];
    return (
      joint.turns === other?.turns &&
      Math.abs((joint.from ?? 0) - (other?.from ?? 0)) <= ANGLE &&
      Math.abs((joint.to ?? 0) - (other?.to ?? 0)) <= ANGLE
    );
  });
}

/** @throws {Error} where `solve` and `check` do not say the same of one model. */
export function compareChecked(solved, checked) {
  if (solved.buildable && !checked.buildable) {
    throw new Error(`solve says buildable, check not: ${JSON.stringify(checked.problems)}`);
  }
  if (itemsOf(solved) !== itemsOf(checked)) {
    throw new Error(`solve: ${itemsOf(solved)}; check: ${itemsOf(checked)}`);
  }
}

function compareMoved(checked, moved) {
  if (checked.buildable !== moved.buildable || verdictOf(checked) !== verdictOf(moved)) {
    throw new Error(`before the motion: ${verdictOf(checked)}; after: ${verdictOf(moved)}`);
  }
  if (!sameJoints(checked, moved)) {
    throw new Error(
      `joints before: ${JSON.stringify(checked.joints)}; after: ${JSON.stringify(moved.joints)}`,
    );
  }
}

async function mustAgreeWhenMoved(door, { model, checked, seed }, motion) {
  const way = rigidMotion(seed + 1e6 * motion, model.sketch);
  const moved = await door.check(JSON.stringify(movedModel(model, way)), `motion ${motion}`);
  if (moved === null) {
    throw new Error(`check refuses the model after motion ${motion}`);
  }
  try {
    compareMoved(checked, moved);
  } catch (error) {
    throw new Error(`motion ${motion}: ${error.message}`);
  }
}

/**
 * Solves, checks, moves and checks one seed.
 * @returns {Promise<'buildable' | 'not buildable' | 'refused'>} what came of it.
 * @throws {Error} where something does not hold.
 */
export async function tryCase({ door, readers, motions, isSmall }, seed) {
  const { sketch, settings } = fuzzCase(seed, { isSmall });
  if (seed % CANCEL_EVERY === 0) {
    await door.cancel?.(sketch, settings, (seed / CANCEL_EVERY) % MOST_STEPS);
  }
  const solved = await door.solve(sketch, settings);
  if (solved === null) {
    return 'refused';
  }
  const { report, modelText, mpd } = solved;
  const checked = await door.check(modelText, 'the model');
  if (checked === null) {
    throw new Error('check refuses the model that solve wrote');
  }
  compareChecked(report, checked);
  await compareLink(readers, sketch);
  const model = JSON.parse(modelText);
  compareMpd(readers, model, mpd);
  for (let motion = 0; motion < motions; ++motion) {
    await mustAgreeWhenMoved(door, { model, checked, seed }, motion);
  }
  return report.buildable ? 'buildable' : 'not buildable';
}
