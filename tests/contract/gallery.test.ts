import { beforeAll, describe, expect, it } from 'vitest';
import { trainPath } from '../../web/src/model/gear-motion.ts';
import type { Model, PlacedPart } from '../../web/src/model/model.ts';
import { posesAt, readMotionAnswer, readMotionPath } from '../../web/src/model/motion.ts';
import type { SketchDocument } from '../../web/src/model/sketch.ts';
import type { SolverModule } from '../../web/src/solver/solver-module.ts';
import { placeTrain, readGearTrain, withTrain } from '../../web/src/ui/gallery/gear-train.ts';
import { catalogue } from '../web/view/helpers/catalogue.ts';
import {
  type GalleryTestRow,
  modelOf,
  galleryRows as models,
  galleryText as text,
} from './gallery-rows.ts';
import { loadModule } from './module.ts';

// What the gallery moves, judged by the module that the page ships.

interface Check {
  readonly buildable: boolean;
  readonly items: readonly { readonly id: string; readonly ok: boolean }[];
  readonly problems: readonly { readonly message: string }[];
}

let module: SolverModule;

beforeAll(async () => {
  module = await loadModule();
});

const solved = (row: GalleryTestRow): string => modelOf(row, module);

function checked(model: object): Check {
  const reply = module.checkModelJson(JSON.stringify(model));
  expect(reply.status).toBe('ok');
  return JSON.parse(reply.text) as Check;
}

const collisionsOf = (check: Check) =>
  check.items.find(({ id }) => id === 'interpenetration')?.ok
    ? []
    : check.problems.map(({ message }) => message);

/** Models that turn on shafts, without a joint. */
const isDriven = (row: GalleryTestRow) => row.moves && text(row.file).includes('"shafts"');

describe.each(models.filter(isDriven))('shafts of $id', (row) => {
  it('turn, and nothing collides on the way', () => {
    const json = solved(row);
    const model = JSON.parse(json) as Model & { readonly sketch: SketchDocument };
    const { trains } = readMotionAnswer(module.analyseMotionJson(json).text);
    const drawn = trains.flatMap(({ shafts }) => shafts.map((shaft) => shaft.drawn));
    const numbers = model.sketch.shafts?.map((_, i) => i);
    expect(drawn.filter((shaft) => shaft !== null).sort()).toEqual(numbers);
    for (const train of trains) {
      const path = trainPath(train, model.parts, model.sketch.drives);
      expect(path.turns, path.message).toBe(true);
      for (const degrees of [37, 100, 190, 290]) {
        const poses = posesAt(path, degrees);
        const parts = model.parts.map((part, i) => ({ ...part, ...poses.get(i) }));
        const { sketch: _, ...moved } = model;
        expect(collisionsOf(checked({ ...moved, parts }))).toEqual([]);
      }
    }
  }, 180_000);
});

const isJointed = (row: GalleryTestRow) => row.moves && !isDriven(row);

describe.each(models.filter(isJointed))('joints of $id', (row) => {
  it('turn within their ranges, and nothing collides on the way', () => {
    const json = solved(row);
    const model = JSON.parse(json) as { parts: PlacedPart[]; sketch: { joints: unknown[] } };
    const { joints } = readMotionAnswer(module.analyseMotionJson(json).text);
    expect(joints).toHaveLength(model.sketch.joints.length);
    expect(joints.length).toBeGreaterThan(0);
    for (const joint of joints) {
      expect(joint.turns, joint.message).toBe(true);
      expect(joint.from).toBeLessThanOrEqual(0);
      expect(joint.to - joint.from).toBeGreaterThan(5);
      const path = readMotionPath(module.jointMotionJson(json, joint.index).text);
      expect(path.angles[0]).toBeCloseTo(joint.from, 0);
      expect(path.angles.at(-1)).toBeCloseTo(joint.to, 0);
      // Each check of a large model takes as long as all of a small one.
      for (const share of row.made ? [0.8] : [0.05, 0.35, 0.65, 0.95]) {
        const poses = posesAt(path, joint.from + share * (joint.to - joint.from));
        const parts = model.parts.map((part, i) => ({ ...part, ...poses.get(i) }));
        expect(poses.size).toBeGreaterThan(0);
        const { sketch: _, ...moved } = model;
        expect(collisionsOf(checked({ ...moved, parts }))).toEqual([]);
      }
    }
  }, 180_000);
});

describe.each(models.filter(({ gears }) => gears))('gears of $id', (row) => {
  const train = () => {
    const read = readGearTrain(JSON.parse(text(row.gears ?? '')), catalogue);
    if (!read.ok) {
      throw new Error(read.message);
    }
    return read.value;
  };

  it('make one buildable model with their frame', () => {
    const check = checked(JSON.parse(withTrain(solved(row), train(), catalogue)) as object);
    expect(check.problems).toEqual([]);
    expect(check.buildable).toBe(true);
  });

  // The module takes a gear as the cylinder that its teeth sweep.
  it('touch nothing while they turn', () => {
    const whole = JSON.parse(withTrain(solved(row), train(), catalogue)) as {
      parts: PlacedPart[];
    };
    const still = whole.parts.length - placeTrain(train(), 0, catalogue).length;
    for (const turn of [0.1, 0.4, 1.1, 2.9]) {
      const turned = placeTrain(train(), turn, catalogue);
      const parts = [...whole.parts.slice(0, still), ...turned];
      expect(collisionsOf(checked({ ...whole, parts }))).toEqual([]);
    }
  });

  it('would be found in a beam, or too near each other', () => {
    const whole = JSON.parse(withTrain(solved(row), train(), catalogue)) as {
      parts: PlacedPart[];
    };
    const gear = whole.parts.findIndex(({ part }) => part === '3649');
    for (const shift of [
      [0, 1, 0],
      [-0.5, 0, 0],
      [0, -3, 0],
    ] as const) {
      const parts = whole.parts.map((part, i) => {
        const [x, y, z] = part.position;
        const position = [x + shift[0], y + shift[1], z + shift[2]] as const;
        return i === gear ? { ...part, position } : part;
      });
      expect(collisionsOf(checked({ ...whole, parts }))).not.toEqual([]);
    }
  });
});
