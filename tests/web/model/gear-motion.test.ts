import { describe, expect, it } from 'vitest';
import { IDENTITY, rotate } from '../../../web/src/geometry/vec.ts';
import {
  driverOf,
  type GearTrain,
  gearingOf,
  trainPath,
} from '../../../web/src/model/gear-motion.ts';
import { posesAt } from '../../../web/src/model/motion.ts';
import { nearestAngle } from '../../../web/src/model/motion-follow.ts';
import { isFullTurn, spanOf } from '../../../web/src/model/motion-span.ts';

/** Shafts along y at x = 0 and x = 3, the second as fast as told; part 0 and 1 on the first, 2 on the second. */
function train(speed: number): GearTrain {
  const axis = [0, 1, 0] as const;
  return {
    index: 0,
    turns: true,
    message: '',
    shafts: [
      { parts: [0, 1], drawn: 0, at: [0, 0, 0], axis, speed: 1 },
      { parts: [2], drawn: 1, at: [3, 0, 0], axis, speed },
    ],
  };
}

const PARTS = [0, 0, 3].map((x) => ({ position: [x, 1, 0] as const, rotation: IDENTITY }));

/** How far a part is turned about y, degrees. */
function turnOf(path: ReturnType<typeof trainPath>, degrees: number, part: number): number {
  const [x, , z] = rotate(posesAt(path, degrees).get(part)?.rotation ?? IDENTITY, [1, 0, 0]);
  return (Math.atan2(-z, x) * 180) / Math.PI;
}

describe('the motion of a train', () => {
  it('turns each shaft at its own speed', () => {
    const path = trainPath(train(-0.5), PARTS);
    expect(turnOf(path, 50, 1)).toBeCloseTo(50);
    expect(turnOf(path, 50, 2)).toBeCloseTo(-25);
  });

  it('leaves parts on their axes', () => {
    const path = trainPath(train(-0.5), PARTS);
    const [x, y, z] = posesAt(path, 77).get(2)?.position ?? [];
    expect([x, y, z].map((v) => Math.round((v ?? 9) * 1e9) / 1e9)).toEqual([3, 1, 0]);
  });

  it('goes on until everything is where it began', () => {
    const path = trainPath(train(-0.4), PARTS);
    const span = spanOf(path);
    expect(span.to).toBe(5 * 360);
    expect(isFullTurn(span)).toBe(true);
    expect(posesAt(path, span.to).get(2)?.rotation[0]).toBeCloseTo(1);
  });

  it('goes there and back where that would take too long', () => {
    const span = spanOf(trainPath(train(1 / 37.5), PARTS));
    expect(isFullTurn(span)).toBe(false);
  });

  it('is driven by the shaft that drives in the drawing', () => {
    const drives = [{ from: 1, to: 0, ratio: 2 }];
    expect(driverOf(train(-0.5), drives)?.drawn).toBe(1);
    expect(turnOf(trainPath(train(-0.5), PARTS, drives), 10, 0)).toBeCloseTo(-20);
  });

  it('is played slowly where a shaft would be too fast for the eye', () => {
    expect(trainPath(train(-0.5), PARTS).pace).toBe(1);
    expect(trainPath(train(-10), PARTS).pace).toBeCloseTo(0.2);
  });

  it('says why there is none', () => {
    const path = trainPath({ ...train(1), turns: false, message: 'Stuck.' }, PARTS);
    expect([path.turns, path.message, path.parts]).toEqual([false, 'Stuck.', []]);
  });

  it('follows a pointer on a slow shaft as far as on a fast one', () => {
    const path = trainPath(train(-0.1), PARTS);
    const wanted = 30; // of the slow shaft
    const off = (degrees: number) => Math.abs(-0.1 * degrees + wanted);
    const found = nearestAngle(spanOf(path), 0, off, gearingOf(path, 2));
    expect(found).toBeCloseTo(300, 0);
  });
});
