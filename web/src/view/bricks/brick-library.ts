import { BufferAttribute, BufferGeometry } from 'three';
import type { Catalogue, Part } from '../../model/catalogue.ts';
import type { DetailName } from './detail.ts';
import type { BrickMesh } from './mesh-builder.ts';
import { buildPartMesh } from './part-mesh.ts';

/** Surface and lines of one part at one level of detail, ready to be drawn many times. */
export interface BrickGeometry {
  readonly surface: BufferGeometry;
  /** `position`, `normal1`, `normal2` at line ends; see BrickMesh. */
  readonly lines: BufferGeometry;
  readonly mesh: BrickMesh;
}

/** Triangles of an ordinary part, for parts that are not built yet. */
const USUAL_TRIANGLES: Readonly<Record<DetailName, number>> = {
  ultra: 4500,
  high: 2200,
  medium: 1100,
  low: 400,
};

/** Builds each part's geometry when it is first asked for and keeps it. */
export class BrickLibrary {
  readonly catalogue: Catalogue;
  readonly #cache = new Map<string, { readonly part: Part; readonly geometry: BrickGeometry }>();

  constructor(catalogue: Catalogue) {
    this.catalogue = catalogue;
  }

  /** The geometry of a part, or null when the catalogue does not have it. */
  get(id: string, detail: DetailName): BrickGeometry | null {
    const known = this.built(id, detail);
    if (known) {
      return known;
    }
    const part = this.catalogue.find(id);
    if (!part) {
      return null;
    }
    const geometry = toGeometry(buildPartMesh(part, detail));
    this.#cache.set(`${id}/${detail}`, { part, geometry });
    return geometry;
  }

  /** The geometry of a part if it is built already. */
  built(id: string, detail: DetailName): BrickGeometry | null {
    const known = this.#cache.get(`${id}/${detail}`);
    // Another file's part may bear the same number.
    return known && known.part === this.catalogue.find(id) ? known.geometry : null;
  }

  /** How many triangles a part has: about, as long as it is not built. */
  triangles(id: string, detail: DetailName): number {
    const known = this.built(id, detail);
    return known ? known.mesh.indices.length / 3 : USUAL_TRIANGLES[detail];
  }

  dispose(): void {
    for (const { geometry } of this.#cache.values()) {
      geometry.surface.dispose();
      geometry.lines.dispose();
    }
    this.#cache.clear();
  }
}

function toGeometry(mesh: BrickMesh): BrickGeometry {
  const surface = new BufferGeometry();
  surface.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  surface.setAttribute('normal', new BufferAttribute(mesh.normals, 3));
  surface.setAttribute('color', new BufferAttribute(greys(mesh.shades), 3));
  surface.setIndex(new BufferAttribute(mesh.indices, 1));
  const lines = new BufferGeometry();
  lines.setAttribute('position', new BufferAttribute(mesh.linePositions, 3));
  lines.setAttribute('normal1', new BufferAttribute(mesh.lineNormals1, 3));
  lines.setAttribute('normal2', new BufferAttribute(mesh.lineNormals2, 3));
  return { surface, lines, mesh };
}

function greys(shades: Float32Array): Float32Array {
  const colours = new Float32Array(shades.length * 3);
  shades.forEach((shade, i) => {
    colours.fill(shade, i * 3, i * 3 + 3);
  });
  return colours;
}
