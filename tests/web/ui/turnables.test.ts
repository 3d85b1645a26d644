import { expect, test } from 'vitest';
import type { GearTrain } from '../../../web/src/model/gear-motion.ts';
import type { JointRange } from '../../../web/src/model/motion.ts';
import { turnablesOf } from '../../../web/src/ui/checks/turnables.ts';

const JOINT: JointRange = {
  index: 0,
  joint: 0,
  turns: true,
  from: -180,
  to: 180,
  stoppedBy: { from: [], to: [] },
  message: '',
};

function train(speeds: readonly number[], drawn: readonly (number | null)[]): GearTrain {
  return {
    index: 0,
    turns: true,
    message: '',
    shafts: speeds.map((speed, i) => ({
      parts: [i],
      drawn: drawn[i] ?? null,
      at: [i, 0, 0],
      axis: [0, 1, 0],
      speed,
    })),
  };
}

const says = (trains: readonly GearTrain[], drives: readonly { from: number; to: number }[]) =>
  turnablesOf(
    { joints: [], trains },
    { drives: drives.map((drive) => ({ ...drive, ratio: 1 })) },
  ).map(({ name, says: text }) => `${name}: ${text}`);

test('joints come before trains', () => {
  const rows = turnablesOf({ joints: [JOINT], trains: [train([1, -1], [0, 1])] });
  expect(rows.map(({ name }) => name)).toEqual(['Joint 1', 'Shafts 1, 2']);
});

test('a train says its ratio as its first shaft drives the other', () => {
  expect(says([train([1, -3, 1 / 15], [0, null, 1])], [{ from: 0, to: 1 }])).toEqual([
    'Shafts 1, 2: 15 : 1',
  ]);
  expect(says([train([1, -3, 1 / 15], [0, null, 1])], [{ from: 1, to: 0 }])).toEqual([
    'Shafts 1, 2: 1 : 15',
  ]);
});

test('a shaft alone goes all the way round', () => {
  expect(says([train([1], [2])], [])).toEqual(['Shaft 3: all the way round']);
});

test('a train that nobody drew has a number', () => {
  expect(says([train([1, -0.5], [null, null])], [])).toEqual(['Gear train 1: 2 : 1']);
});
