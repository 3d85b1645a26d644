import { cross, normalize, subtract, type Vec3 } from '../../geometry/vec.ts';
import type { GuestKind } from '../../model/guests.ts';
import { type BrickMesh, MeshBuilder } from './mesh-builder.ts';
import { signLines } from './sign.ts';

/** Lines of a label lie this far before its face. */
const BEFORE = 0.01;
/** How much of a face's breadth and height a label takes. */
const FILLED = { across: 0.86, up: 0.5 } as const;
const TALLEST = 0.8;
const EMPTY: Vec3 = [0, 0, 0];

/** The mesh of a part that is not in the catalogue: its own surfaces, or its box with its number on it. */
export function buildGuestMesh(kind: GuestKind): BrickMesh {
  const builder = new MeshBuilder();
  if (kind.faces.length > 0) {
    addSurfaces(builder, kind);
  } else {
    addBox(builder, kind);
    addLabels(builder, kind);
  }
  return builder.build();
}

/** Files do not say which side of a surface is outside: both are drawn. */
function addSurfaces(builder: MeshBuilder, { faces, lines }: GuestKind): void {
  for (let i = 0; i + 8 < faces.length; i += 9) {
    const [a, b, c] = [pointAt(faces, i), pointAt(faces, i + 3), pointAt(faces, i + 6)];
    builder.flatFan([a, b, c]);
    builder.flatFan([a, c, b]);
  }
  for (let i = 0; i + 5 < lines.length; i += 6) {
    builder.hardLine(pointAt(lines, i), pointAt(lines, i + 3));
  }
}

function pointAt(numbers: readonly number[], i: number): Vec3 {
  return [numbers[i] ?? 0, numbers[i + 1] ?? 0, numbers[i + 2] ?? 0];
}

/** Corners by three bits, x lowest. */
const SIDES = [
  [0, 4, 6, 2],
  [1, 3, 7, 5],
  [0, 1, 5, 4],
  [2, 6, 7, 3],
  [0, 2, 3, 1],
  [4, 5, 7, 6],
] as const;

function addBox(builder: MeshBuilder, { min, max }: GuestKind): void {
  const corner = (bits: number): Vec3 => [
    bits & 1 ? max[0] : min[0],
    bits & 2 ? max[1] : min[1],
    bits & 4 ? max[2] : min[2],
  ];
  for (const [a, b, c, d] of SIDES) {
    builder.flatQuad([corner(a), corner(b), corner(c), corner(d)]);
  }
  for (let bits = 0; bits < 8; bits++) {
    for (const bit of [1, 2, 4]) {
      if (!(bits & bit)) {
        builder.hardLine(corner(bits), corner(bits | bit));
      }
    }
  }
}

/** The number, written along the longer side of each of the two broadest faces. */
function addLabels(builder: MeshBuilder, { id, min, max }: GuestKind): void {
  const size = subtract(max, min);
  const order: (0 | 1 | 2)[] = [0, 1, 2];
  order.sort((i, j) => size[j] - size[i]);
  const [along = 0, up = 1, out = 2] = order;
  const sign = signLines(id);
  const scale = Math.min((FILLED.across * size[along]) / sign.width, FILLED.up * size[up], TALLEST);
  for (const side of [-1, 1] as const) {
    const middle: [number, number, number] = [0, 1, 2].map(
      (k) => ((min[k] ?? 0) + (max[k] ?? 0)) / 2,
    ) as [number, number, number];
    middle[out] += side * (size[out] / 2 + BEFORE);
    // From left to right as seen from outside.
    const flip = handed(along, up, out) * side;
    const place = ([x, y]: readonly [number, number]): Vec3 => {
      const point: [number, number, number] = [...middle];
      point[along] += flip * scale * (x - sign.width / 2);
      point[up] += scale * (y - 0.5);
      return point;
    };
    for (const [a, b] of sign.lines) {
      builder.hardLine(place(a), place(b));
    }
  }
}

/** 1 where three axes in this order are right-handed. */
function handed(x: number, y: number, z: number): number {
  const unit = (k: number): Vec3 => [k === 0 ? 1 : 0, k === 1 ? 1 : 0, k === 2 ? 1 : 0];
  const normal = normalize(cross(unit(x), unit(y)));
  return (normal[z as 0 | 1 | 2] ?? EMPTY[0]) > 0 ? 1 : -1;
}
