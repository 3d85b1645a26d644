import type { Vec3 } from '../../geometry/vec.ts';
import type { BuildStep } from '../../instructions/build-steps.ts';
import type { Model } from '../../model/model.ts';
import { drawDepth } from '../../view/drawing/depth-buffer.ts';
import { cameraFor } from '../../view/drawing/drawing-camera.ts';
import { type DrawnPart, drawn, type MeshShelf } from '../../view/drawing/drawn-part.ts';

const PROBE = { width: 128, height: 96, margin: 2 } as const;
/** Less of the new parts in sight than this, and another side is tried. */
const ENOUGH = 0.14;
/** Another side must show so many times more to be worth a turn. */
const WORTH = 2;

const up = 0.62;
/** Sides that a step may be seen from: quarter turns, then from below. */
const SIDES: readonly Vec3[] = [
  [0.62, -0.78, up],
  [-0.62, 0.78, up],
  [0.62, 0.78, up],
  [-0.62, -0.78, -up],
  [0.62, 0.78, -up],
];

/** The side to look from: the one before, unless the new parts cannot be seen from there. */
export function chooseDirection(
  model: Model,
  step: BuildStep,
  before: Vec3,
  shelf: MeshShelf,
): Vec3 {
  const here = sightOf(model, step, before, shelf);
  if (here >= ENOUGH) {
    return before;
  }
  let best = { direction: before, sight: here };
  for (const direction of SIDES) {
    const sight = sightOf(model, step, direction, shelf);
    if (sight > best.sight) {
      best = { direction, sight };
    }
    if (sight >= 3 * ENOUGH) {
      break;
    }
  }
  return best.sight > WORTH * here ? best.direction : before;
}

/** The share of the new parts' pixels that nothing hides, 0 to 1. */
function sightOf(model: Model, step: BuildStep, out: Vec3, shelf: MeshShelf): number {
  const pick = (indices: readonly number[]): DrawnPart[] =>
    indices.flatMap((index) => {
      const part = model.parts[index];
      return part ? [drawn(part)] : [];
    });
  const added = pick(step.adds.flatMap((add) => add.parts));
  const all = [...added, ...pick(step.before)];
  const camera = cameraFor(
    added.flatMap((part) => shelf.corners(part)),
    out,
    PROBE,
  );
  const alone = drawDepth(added, camera, shelf, 'low');
  const together = drawDepth(all, camera, shelf, 'low');
  let total = 0;
  let seen = 0;
  for (let i = 0; i < alone.owner.length; i++) {
    if ((alone.owner[i] ?? -1) >= 0) {
      total += 1;
      const owner = together.owner[i] ?? -1;
      seen += owner >= 0 && owner < added.length ? 1 : 0;
    }
  }
  return total > 0 ? seen / total : 1;
}
