import { isRange, type SketchDocument, versionOf } from '../model/sketch.ts';

/** For each joint its range, or 0 where it has none. */
export function encodeRanges(sketch: SketchDocument): unknown[] {
  return (sketch.joints ?? []).map((joint) => joint.range ?? 0);
}

/** The sketch with its joints' ranges; null when they are none. */
export function decodeRanges(sketch: SketchDocument, value: unknown): SketchDocument | null {
  const joints = sketch.joints ?? [];
  if (!Array.isArray(value) || value.length !== joints.length) {
    return null;
  }
  const ranges: unknown[] = value;
  if (!ranges.every((range) => range === 0 || isRange(range))) {
    return null;
  }
  const ranged = joints.map((joint, i) => {
    const range = ranges[i];
    return isRange(range) ? { ...joint, range } : joint;
  });
  const next = ranged.length > 0 ? { ...sketch, joints: ranged } : sketch;
  return { ...next, version: versionOf(next) };
}
