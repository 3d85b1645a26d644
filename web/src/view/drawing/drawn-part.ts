import { add, type Mat3, rotate, type Vec3 } from '../../geometry/vec.ts';
import { type Bounds, corners } from '../../model/bounds.ts';
import type { Catalogue, Part } from '../../model/catalogue.ts';
import { colourHex } from '../../model/colours.ts';
import type { PlacedPart } from '../../model/model.ts';
import type { DetailName } from '../bricks/detail.ts';
import type { BrickMesh } from '../bricks/mesh-builder.ts';
import { buildPartMesh } from '../bricks/part-mesh.ts';

/** A part as it stands in a picture. */
export interface DrawnPart {
  readonly part: string;
  readonly position: Vec3;
  readonly rotation: Mat3;
  /** sRGB, 0xRRGGBB. */
  readonly hex: number;
  /** Parts of one non-zero group get an outline together, as new parts of a step. */
  readonly outline?: number;
}

/** A placed part in its own colour. */
export function drawn(part: PlacedPart): DrawnPart {
  const { part: id, position, rotation, color } = part;
  return { part: id, position, rotation, hex: colourHex(color) };
}

/** Meshes by part and level of detail, built when first asked for. */
export class MeshShelf {
  readonly catalogue: Catalogue;
  readonly #meshes = new Map<string, { readonly part: Part; readonly mesh: BrickMesh }>();

  constructor(catalogue: Catalogue) {
    this.catalogue = catalogue;
  }

  /** The mesh of a part in its own frame; null for a part that the catalogue does not hold. */
  get(id: string, detail: DetailName): BrickMesh | null {
    const key = `${id}/${detail}`;
    const known = this.#meshes.get(key);
    const part = this.catalogue.find(id);
    if (!part || known?.part === part) {
      return known?.mesh ?? null;
    }
    const mesh = buildPartMesh(part, detail);
    this.#meshes.set(key, { part, mesh });
    return mesh;
  }

  /** Corners of a part's box in its place; its position alone when it is unknown. */
  corners(part: Pick<DrawnPart, 'part' | 'position' | 'rotation'>): Vec3[] {
    const known = this.catalogue.find(part.part);
    if (!known) {
      return [part.position];
    }
    const box: Bounds = { min: known.boundsMin, max: known.boundsMax };
    return corners(box).map((corner) => add(rotate(part.rotation, corner), part.position));
  }
}
