import { add, dot, length, normalize, scale, type Vec3 } from '../../geometry/vec.ts';
import type { Addition } from '../../instructions/assembly-plan.ts';
import type { BuildStep } from '../../instructions/build-steps.ts';
import { mixHex } from '../../model/colours.ts';
import type { Model } from '../../model/model.ts';
import {
  cameraFor,
  type DrawingCamera,
  ISO_OUT,
  type PictureSize,
  projectPoint,
} from '../../view/drawing/drawing-camera.ts';
import { type DrawnPart, drawn, type MeshShelf } from '../../view/drawing/drawn-part.ts';
import { drawPicture, PICTURE_STYLE, type Picture } from '../../view/drawing/picture.ts';
import type { Book } from './book.ts';

/** An arrow on a picture, pixels. */
export interface Arrow {
  readonly x1: number;
  readonly y1: number;
  readonly x2: number;
  readonly y2: number;
}

export interface StepPicture {
  readonly picture: Picture;
  readonly arrows: readonly Arrow[];
}

/** How pale the parts of earlier steps are, so that the new ones stand out. */
const PALE = 0.32;
/** Length of an arrow beside its part, modules. */
const ARROW = 2.2;
const MAX_ARROWS = 6;
const MAX_PIXELS_PER_MODULE = 46;

/** A step: what was there, what is new with an outline, and arrows along the ways in. */
export function drawStep(book: Book, index: number, size: PictureSize): StepPicture {
  const step = book.steps[index];
  const out = book.directions[index];
  if (!step || !out) {
    throw new RangeError(`no step ${index}`);
  }
  const { model, shelf } = book;
  const added = new Set(step.adds.flatMap((addition) => addition.parts));
  const parts = [...step.before, ...added].flatMap((i): DrawnPart[] => {
    const part = model.parts[i];
    if (!part) {
      return [];
    }
    const shown = drawn(part);
    return added.has(i)
      ? [{ ...shown, outline: 1 }]
      : [{ ...shown, hex: mixHex(shown.hex, 0xffffff, PALE) }];
  });
  const tails = step.adds.flatMap((addition) => arrowEnds(addition, model, shelf));
  const points = [...parts.flatMap((part) => shelf.corners(part)), ...tails.flat()];
  const camera = cameraFor(points, out, { maxScale: MAX_PIXELS_PER_MODULE, ...size });
  return {
    picture: drawPicture(parts, camera, shelf, PICTURE_STYLE),
    arrows: arrowsOf(step, { model, shelf, camera }),
  };
}

function arrowsOf(
  step: BuildStep,
  scene: { readonly model: Model; readonly shelf: MeshShelf; readonly camera: DrawingCamera },
): Arrow[] {
  return step.adds.slice(0, MAX_ARROWS).flatMap((addition) =>
    arrowEnds(addition, scene.model, scene.shelf).flatMap(([from, to]) => {
      const a = projectPoint(scene.camera, from);
      const b = projectPoint(scene.camera, to);
      // An arrow straight at the eye is a dot.
      return Math.hypot(b[0] - a[0], b[1] - a[1]) > 8
        ? [{ x1: a[0], y1: a[1], x2: b[0], y2: b[1] }]
        : [];
    }),
  );
}

/** Beside the parts on the side that they come from, and at their rim. */
function arrowEnds(addition: Addition, model: Model, shelf: MeshShelf): (readonly [Vec3, Vec3])[] {
  const { travel } = addition;
  if (length(travel) < 1e-6) {
    return [];
  }
  const direction = normalize(travel);
  const corners = addition.parts.flatMap((i) => {
    const part = model.parts[i];
    return part ? shelf.corners(drawn(part)) : [];
  });
  if (corners.length === 0) {
    return [];
  }
  const middle = scale(
    corners.reduce((sum, p) => add(sum, p), [0, 0, 0] as Vec3),
    1 / corners.length,
  );
  const back = Math.min(...corners.map((p) => dot(p, direction))) - dot(middle, direction);
  const at = (t: number): Vec3 => add(middle, scale(direction, t));
  return [[at(back - ARROW), at(back - 0.15)]];
}

/** A finished subassembly alone, as the reader sees it go in. */
export function drawApart(
  book: Book,
  index: number,
  parts: readonly number[],
  size: PictureSize,
): Picture {
  const { model, shelf, directions } = book;
  const shown = parts.flatMap((i) => {
    const part = model.parts[i];
    return part ? [drawn(part)] : [];
  });
  const points = shown.flatMap((part) => shelf.corners(part));
  const out = directions[index] ?? ISO_OUT;
  return drawPicture(shown, cameraFor(points, out, { maxScale: 40, ...size }), shelf);
}

/** One part alone, for lists. */
export function drawPartPicture(
  part: string,
  hex: number,
  shelf: MeshShelf,
  size: PictureSize,
): Picture {
  const shown: DrawnPart = {
    part,
    hex,
    position: [0, 0, 0],
    rotation: lying(part, shelf),
  };
  const camera = cameraFor(shelf.corners(shown), [-0.5, -0.8, 0.75], { maxScale: 40, ...size });
  return drawPicture([shown], camera, shelf);
}

/** Lists show long parts along x, with their holes towards the reader. */
function lying(part: string, shelf: MeshShelf): DrawnPart['rotation'] {
  const known = shelf.catalogue.find(part);
  const size = known ? known.boundsMax.map((max, k) => max - (known.boundsMin[k] ?? 0)) : [1, 1, 1];
  const [x = 0, y = 0, z = 0] = size;
  if (y >= x && y >= z) {
    return [0, 1, 0, -1, 0, 0, 0, 0, 1];
  }
  return z > x ? [0, 0, 1, 0, 1, 0, -1, 0, 0] : [1, 0, 0, 0, 1, 0, 0, 0, 1];
}
