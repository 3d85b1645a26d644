import { add, dot, scale, subtract, type Vec3 } from '../../geometry/vec.ts';
import { isHole, type Part } from '../../model/catalogue.ts';
import type { Detail } from './detail.ts';
import { addAxleHole, addPinHole, axleHoleOpening, pinHoleOpening } from './holes.ts';
import { type Frame, frameAlong, type MeshBuilder, type Point2, toPart } from './mesh-builder.ts';
import { addPolygon } from './plate.ts';

/** Teeth are 2.25 mm high on gears whose pitch grows by 1 mm a tooth (module 1). */
const TOOTH_HEIGHT = 2.25 / 8;
/** Where a tooth's flank starts and ends, as shares of the pitch from the tooth's middle. */
const FLANK = { foot: 0.28, tip: 0.11 } as const;

/**
 * Adds a spur gear: a toothed disc with the part's holes. Bevels and hubs are not drawn.
 * @returns false when the part is no gear with teeth to count.
 */
export function addGear(builder: MeshBuilder, part: Part, detail: Detail): boolean {
  const disc = part.solid[0];
  const teeth = Number(/(\d+) Tooth/.exec(part.name)?.[1] ?? 0);
  if (part.partClass !== 'gear' || !disc || teeth < 6) {
    return false;
  }
  const frame = frameAlong(disc.from, disc.axis);
  const outline = toothedOutline(teeth, disc.radius);
  const height = disc.halfThickness;
  addToothedWall(builder, frame, outline, height);
  const holes = part.features
    .filter((feature) => isHole(feature.kind) && Math.abs(dot(feature.axis, frame.z)) > 0.99)
    .map((feature) => {
      const [x, y] = flat(frame, feature.center);
      const origin = add(frame.origin, add(scale(frame.x, x), scale(frame.y, y)));
      if (feature.kind === 'pinHole') {
        addPinHole(builder, { ...frame, origin }, height, detail);
        return pinHoleOpening(x, y, detail);
      }
      const own = frameAlong(origin, frame.z, feature.wing);
      addAxleHole(builder, own, height);
      return axleHoleOpening(x, y, Math.atan2(dot(own.x, frame.y), dot(own.x, frame.x)));
    });
  for (const side of [1, -1]) {
    addPolygon(builder, frame, { contour: outline, holes }, side * height);
  }
  return true;
}

function flat(frame: Frame, point: Vec3): Point2 {
  const offset = subtract(point, frame.origin);
  return [dot(offset, frame.x), dot(offset, frame.y)];
}

/** Counter-clockwise; four corners a tooth, a tooth's middle at angle 0. */
function toothedOutline(teeth: number, radius: number): Point2[] {
  const pitch = (2 * Math.PI) / teeth;
  const root = radius - TOOTH_HEIGHT;
  return Array.from({ length: teeth }, (_, i) => i * pitch).flatMap((middle) =>
    (
      [
        [root, -FLANK.foot],
        [radius, -FLANK.tip],
        [radius, FLANK.tip],
        [root, FLANK.foot],
      ] as const
    ).map(([r, share]): Point2 => {
      const angle = middle + share * pitch;
      return [r * Math.cos(angle), r * Math.sin(angle)];
    }),
  );
}

function addToothedWall(
  builder: MeshBuilder,
  frame: Frame,
  outline: readonly Point2[],
  height: number,
): void {
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length] ?? a;
    const low = (p: Point2): Vec3 => toPart(frame, p[0], p[1], -height);
    const high = (p: Point2): Vec3 => toPart(frame, p[0], p[1], height);
    builder.flatQuad([low(a), low(b), high(b), high(a)]);
    builder.hardLine(low(a), low(b));
    builder.hardLine(high(a), high(b));
    builder.hardLine(low(a), high(a));
  });
}
