import { type JointFrame, jointFrame, onRing } from '../geometry/joint-frame.ts';
import { add, distance, scale, subtract, type Vec3 } from '../geometry/vec.ts';
import type { SketchDocument, SketchJoint } from '../model/sketch.ts';
import { bodiesOf } from '../state/joint-edits.ts';

/** What can be dragged at the ring of a joint. */
export type JointHandle = 'axis' | 'axisEnd' | 'from' | 'to';

const RING = { pixels: 62, least: 1, most: 9 } as const;
/** The ends of the axis lie so many radii from the middle. */
const AXIS_REACH = 1.35;
/** Where the ends of a range wait while none is asked for, and how far those of a full turn stand apart, degrees. */
const WAITING = 16;
const FULL = 176;

/** Modules: the ring has one size on screen, within reason. */
export function ringRadius(pixelsPerModule: number): number {
  return Math.min(RING.most, Math.max(RING.least, RING.pixels / pixelsPerModule));
}

/** Where the angles of a joint of a sketch are counted from: along the first line of its second body. */
export function frameOf(sketch: SketchDocument, joint: SketchJoint): JointFrame {
  const mover = bodiesOf(sketch, joint)[1]?.[0];
  const line = mover === undefined ? undefined : sketch.lines[mover];
  const ends = line ? [line.to, line.from] : [joint.at];
  const far = ends.reduce((a, b) => (distance(b, joint.at) > distance(a, joint.at) ? b : a));
  return jointFrame(joint.at, joint.axis, subtract(far, joint.at));
}

/** Places of the four handles. */
export function handlePlaces(
  frame: JointFrame,
  range: SketchJoint['range'],
  radius: number,
): Readonly<Record<JointHandle, Vec3>> {
  const out = scale(frame.axis, radius * AXIS_REACH);
  const [from, to] = range ?? [-WAITING, WAITING];
  return {
    axis: add(frame.at, out),
    axisEnd: subtract(frame.at, out),
    from: onRing(frame, Math.max(-FULL, from), radius),
    to: onRing(frame, Math.min(FULL, to), radius),
  };
}
