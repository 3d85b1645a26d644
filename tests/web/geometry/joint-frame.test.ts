import { describe, expect, it } from 'vitest';
import { angleOf, draggedEnd, jointFrame, onRing } from '../../../web/src/geometry/joint-frame.ts';

describe('the ring of a joint', () => {
  const frame = jointFrame([1, 2, 3], [0, 0, 2], [5, 0, 4]);

  it('counts right-handed from where the moving line lies', () => {
    const at = onRing(frame, 90, 2);
    expect(at[0]).toBeCloseTo(1);
    expect(at[1]).toBeCloseTo(4);
    expect(at[2]).toBeCloseTo(3);
  });

  it('gives a point the angle that leads there', () => {
    for (const degrees of [-179, -90, -1, 0, 45, 180]) {
      expect(angleOf(frame, onRing(frame, degrees, 3))).toBeCloseTo(degrees);
    }
  });

  it('finds a zero for a line that lies along the axis', () => {
    const upright = jointFrame([0, 0, 0], [0, 0, 1], [0, 0, 4]);
    expect(Math.hypot(...upright.zero)).toBeCloseTo(1);
    expect(upright.zero[2]).toBeCloseTo(0);
  });
});

describe('the end of a range that is dragged', () => {
  it('stays at nothing on the other side of the drawn pose', () => {
    expect(draggedEnd(1, 20, -10)).toBe(0);
  });

  it('stays at the half turn beyond it', () => {
    expect(draggedEnd(1, 170, -175)).toBe(180);
    expect(draggedEnd(-1, -170, 175)).toBe(-180);
  });
});
