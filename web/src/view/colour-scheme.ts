import type { Mat3, Vec3 } from '../geometry/vec.ts';
import { type Catalogue, isHole } from '../model/catalogue.ts';
import { colourHex, groupHex } from '../model/colours.ts';
import type { PlacedPart } from '../model/model.ts';
import type { ColourScheme } from './view-types.ts';

/** Hole axes along x, y, z, and askew. */
export const AXIS_HEX = { x: 0xc4565b, y: 0x4f9d5d, z: 0x4a7fd0, askew: 0x8d6cc4 } as const;
const NEUTRAL = 0xb8bcc2;
/** How much of a unit vector must lie along an axis to be along it. */
const ALONG = 0.999;

/** sRGB of a part in a colour scheme. */
export function schemeHex(part: PlacedPart, scheme: ColourScheme, catalogue: Catalogue): number {
  switch (scheme) {
    case 'part':
      return colourHex(part.color);
    case 'layer':
      // 0, -1, 1, -2, 2, ... so that layers on both sides of a line differ.
      return groupHex(part.component < 0 ? -1 : layerIndex(part.layer));
    case 'axis':
      return axisHex(part, catalogue);
    case 'component':
      return groupHex(part.component);
    case 'piece':
      return groupHex(part.piece);
  }
}

function layerIndex(layer: number): number {
  return layer > 0 ? 2 * layer : -2 * layer - (layer < 0 ? 1 : 0);
}

/** Beams by the axis of their holes in space; everything else is neutral. */
function axisHex(placed: PlacedPart, catalogue: Catalogue): number {
  const part = catalogue.find(placed.part);
  const hole = part?.partClass === 'beam' ? part.features.find((f) => isHole(f.kind)) : undefined;
  if (!hole) {
    return NEUTRAL;
  }
  const [x, y, z] = turned(placed.rotation, hole.axis);
  if (Math.abs(x) > ALONG) {
    return AXIS_HEX.x;
  }
  if (Math.abs(y) > ALONG) {
    return AXIS_HEX.y;
  }
  return Math.abs(z) > ALONG ? AXIS_HEX.z : AXIS_HEX.askew;
}

function turned(m: Mat3, [x, y, z]: Vec3): Vec3 {
  return [
    m[0] * x + m[1] * y + m[2] * z,
    m[3] * x + m[4] * y + m[5] * z,
    m[6] * x + m[7] * y + m[8] * z,
  ];
}
