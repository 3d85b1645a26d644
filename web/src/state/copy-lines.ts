import {
  cross,
  dot,
  normalize,
  samePoint,
  subtract,
  unitVector,
  type Vec3,
} from '../geometry/vec.ts';
import { lineLength, type SketchDocument, type SketchJoint } from '../model/sketch.ts';
import { type LineMap, lineKey, mapLine } from './edits.ts';
import { passesNode } from './follow-lines.ts';
import { paintLines } from './paint-lines.ts';

/** Sine of the angle below which directions are one. */
const PARALLEL = 1e-3;

/** A sketch with images of some of its lines. */
export interface Copied {
  readonly sketch: SketchDocument;
  /** Lines that were added. */
  readonly added: readonly number[];
}

/**
 * Images of lines under maps, with what is said of them: colours, and joints all of whose lines are among them. An
 * image that lies on a line that is there is that line.
 */
export function copyLines(
  sketch: SketchDocument,
  chosen: ReadonlySet<number>,
  maps: readonly LineMap[],
): Copied {
  let next = sketch;
  for (const map of maps) {
    const placed = withImages(next, { of: sketch, chosen, map });
    next = withJoints(placed.sketch, { of: sketch, map, images: placed.images });
  }
  const added = [...next.lines.keys()].slice(sketch.lines.length);
  return { sketch: added.length > 0 ? next : sketch, added };
}

function withImages(
  sketch: SketchDocument,
  { of, chosen, map }: { of: SketchDocument; chosen: ReadonlySet<number>; map: LineMap },
): { sketch: SketchDocument; images: ReadonlyMap<number, number> } {
  const known = new Map(sketch.lines.map((line, i) => [lineKey(line), i]));
  const lines = [...sketch.lines];
  const images = new Map<number, number>();
  const fresh: (readonly [number, number])[] = [];
  for (const index of chosen) {
    const line = of.lines[index];
    const image = line && mapLine(line, map);
    if (!image || lineLength(image) < 0.5) {
      continue;
    }
    const there = known.get(lineKey(image));
    images.set(index, there ?? lines.length);
    if (there === undefined) {
      known.set(lineKey(image), lines.length);
      fresh.push([index, lines.length]);
      lines.push(image);
    }
  }
  const colours = of.colours?.lines ?? {};
  const painted = fresh.reduce(
    (done: SketchDocument, [from, to]) => {
      const colour = colours[from];
      return colour === undefined ? done : paintLines(done, new Set([to]), colour);
    },
    { ...sketch, lines },
  );
  return { sketch: painted, images };
}

interface JointCopy {
  readonly of: SketchDocument;
  readonly map: LineMap;
  /** Of the chosen lines, by their indices. */
  readonly images: ReadonlyMap<number, number>;
}

function withJoints(sketch: SketchDocument, copy: JointCopy): SketchDocument {
  const before = sketch.joints ?? [];
  const fresh = (copy.of.joints ?? []).flatMap((joint) => {
    const image = jointImage(sketch, joint, copy);
    return image && !before.some((other) => isSame(other, image)) ? [image] : [];
  });
  return fresh.length === 0 ? sketch : { ...sketch, joints: [...before, ...fresh] };
}

/** The joint between the images of its lines; null where not all of them have one. */
function jointImage(
  sketch: SketchDocument,
  joint: SketchJoint,
  { of, map, images }: JointCopy,
): SketchJoint | null {
  const named = joint.between ?? [...of.lines.keys()].map((i) => [i]);
  const bodies = named
    .map((body) => body.filter((i) => passesNode(of.lines[i], joint.at)))
    .filter((body) => body.length > 0);
  if (bodies.length < 2 || !bodies.flat().every((i) => images.has(i))) {
    return null;
  }
  const at = map.point(joint.at);
  const origin = map.point([0, 0, 0]);
  const axis = normalize(subtract(map.point(joint.axis), origin));
  const meeting = sketch.lines.filter((line) => passesNode(line, at)).length;
  const between = bodies.map((body) => body.flatMap((i) => images.get(i) ?? []));
  const { between: _old, range, ...rest } = joint;
  return {
    ...rest,
    at,
    axis: [axis[0] + 0, axis[1] + 0, axis[2] + 0],
    ...(joint.between || meeting > 2 ? { between } : {}),
    ...(range ? { range: isMirror(map) ? mirrored(range) : range } : {}),
  };
}

/** An axis in a mirror points where its image does, and what turns about it turns the other way. */
function mirrored([from, to]: readonly [number, number]): readonly [number, number] {
  return [0 - to, 0 - from];
}

function isMirror({ point }: LineMap): boolean {
  const origin = point([0, 0, 0]);
  const image = (v: Vec3) => subtract(point(v), origin);
  const [x, y, z] = [image(unitVector('x')), image(unitVector('y')), image(unitVector('z'))];
  return dot(cross(x, y), z) < 0;
}

function isSame(a: SketchJoint, b: SketchJoint): boolean {
  const parallel = Math.hypot(...cross(normalize(a.axis), normalize(b.axis))) < PARALLEL;
  return parallel && samePoint(a.at, b.at, 1e-3);
}
