import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../../web/src/geometry/vec.ts';
import type { SketchDocument, SketchJoint } from '../../../web/src/model/sketch.ts';
import { applyDelta, diffSketch, invertDelta } from '../../../web/src/state/delta.ts';
import {
  axisNameOf,
  bodiesOf,
  dropJoint,
  furtherJoint,
  insertJoint,
  jointIndex,
  legalRange,
  likelyJoint,
  linesAlong,
  moveLine,
  placeOfJoint,
  replaceJoint,
  withRange,
} from '../../../web/src/state/joint-edits.ts';

const star = (...ends: Vec3[]): SketchDocument => ({
  format: 'technic-sketch',
  version: 1,
  lines: ends.map((to) => ({ from: [0, 0, 0] as Vec3, to })),
});
const TWO = star([6, 0, 0], [0, 0, 5]);
const THREE = star([6, 0, 0], [0, 0, 5], [-4, 0, 0]);
const O: Vec3 = [0, 0, 0];

describe('the joint that is likely meant', () => {
  it('turns two lines about the axis square to both', () => {
    expect(likelyJoint(TWO, O)).toEqual({ at: O, axis: [0, 1, 0] });
  });

  it('turns lines of one direction against the rest', () => {
    expect(likelyJoint(THREE, O)?.between).toEqual([[0, 2], [1]]);
  });

  it('folds lines in a row', () => {
    expect(likelyJoint(star([6, 0, 0], [-4, 0, 0]), O)).toEqual({
      at: O,
      axis: [0, 0, 1],
      between: [[0], [1]],
    });
  });

  it('is none where one line passes', () => {
    expect(likelyJoint(TWO, [3, 0, 0])).toBeNull();
  });
});

describe('a line that changes sides', () => {
  const joint = likelyJoint(THREE, O) as SketchJoint;
  const clicks = (line: number, times: number) => {
    let now = joint;
    for (let i = 0; i < times; i++) {
      now = moveLine(THREE, now, line);
    }
    return bodiesOf(THREE, now);
  };

  it('goes to the next body', () => {
    expect(clicks(0, 1)).toEqual([[2], [0, 1]]);
  });

  it('then is a body of its own: three on one pin', () => {
    expect(clicks(0, 2)).toEqual([[2], [1], [0]]);
  });

  it('then is no part of the joint, then where it was', () => {
    expect(clicks(0, 3)).toEqual([[2], [1]]);
    expect(clicks(0, 4)).toEqual([[0, 2], [1]]);
  });

  it('never leaves one body alone', () => {
    for (let times = 0; times < 12; times++) {
      expect(clicks(1, times).length).toBeGreaterThanOrEqual(2);
    }
  });

  it('changes which of two bodies is the first', () => {
    const two = likelyJoint(TWO, O) as SketchJoint;
    expect(moveLine(TWO, two, 0).between).toEqual([[1], [0]]);
  });
});

describe('several joints at one node', () => {
  const first = insertJoint(THREE, { at: O, axis: [0, 1, 0], between: [[0], [1]] });

  it('the next one takes a line that none names', () => {
    expect(furtherJoint(first, O)).toEqual({ at: O, axis: [0, 1, 0], between: [[0], [2]] });
  });

  it('are told apart by their places', () => {
    const both = insertJoint(first, { at: O, axis: [0, 1, 0], between: [[0], [2]] });
    expect(placeOfJoint(both, 1)).toEqual({ at: O, nth: 1 });
    expect(jointIndex(both, { at: O, nth: 1 })).toBe(1);
    expect(jointIndex(dropJoint(both, 0), { at: O, nth: 1 })).toBeNull();
  });
});

describe('the axis of a joint', () => {
  it('has a name where holes lie along it', () => {
    expect(axisNameOf({ axis: [0, -2, 0] })).toBe('y');
    expect(axisNameOf({ axis: [0.6, 0.8, 0] })).toBeNull();
  });

  it('along a line turns the line about itself', () => {
    expect(linesAlong(THREE, O, 'z')).toEqual([1]);
  });
});

describe('a required range', () => {
  it('holds the drawn pose and has an extent', () => {
    expect(legalRange(10, 90.4)).toEqual([0, 90]);
    expect(legalRange(-400, 400)).toEqual([-180, 180]);
    expect(legalRange(0, 0)).toBeNull();
  });

  it('makes the sketch one of version 2, and undo one of version 1 again', () => {
    const joint = likelyJoint(TWO, O) as SketchJoint;
    const before = insertJoint(TWO, joint);
    const after = replaceJoint(before, 0, withRange(joint, [-30, 90]));
    const delta = diffSketch(before, after);
    expect([before.version, after.version]).toEqual([1, 2]);
    expect(applyDelta(before, delta)).toEqual(after);
    expect(applyDelta(after, invertDelta(delta))).toEqual(before);
  });
});
