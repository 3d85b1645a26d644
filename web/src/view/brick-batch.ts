import {
  Color,
  DynamicDrawUsage,
  type Group,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  InstancedMesh,
  LineSegments,
  Matrix4,
} from 'three';
import type { Vec3 } from '../geometry/vec.ts';
import { edgeHex } from '../model/colours.ts';
import type { PlacedPart } from '../model/model.ts';
import type { BrickLibrary } from './bricks/brick-library.ts';
import type { BrickMaterials } from './bricks/brick-materials.ts';
import type { DetailName } from './bricks/detail.ts';

/** Attributes of a part's lines that all its batches share. */
const SHARED = ['position', 'normal1', 'normal2'] as const;

/** Whether bricks stand there or are only hinted at. */
export type BatchStyle = 'solid' | 'ghost';

/**
 * All bricks of one part number and style: one draw call for their surfaces and one for their lines.
 */
export class BrickBatch {
  readonly partId: string;
  /** Indices into the model's parts, in the order of the instances. */
  readonly members: readonly number[];
  readonly #surface: InstancedMesh;
  readonly #lines: LineSegments<InstancedBufferGeometry>;
  readonly #edgeColours: InstancedBufferAttribute;
  readonly #library: BrickLibrary;
  #detail: DetailName;

  constructor(
    library: BrickLibrary,
    materials: BrickMaterials,
    content: {
      readonly partId: string;
      readonly members: readonly number[];
      readonly style: BatchStyle;
      readonly detail: DetailName;
    },
  ) {
    const geometry = library.get(content.partId, content.detail);
    if (!geometry) {
      throw new Error(`Part ${content.partId} is not in the catalogue.`);
    }
    this.partId = content.partId;
    this.members = content.members;
    this.#library = library;
    this.#detail = content.detail;
    const solid = content.style === 'solid';
    const count = content.members.length;
    this.#surface = new InstancedMesh(
      geometry.surface,
      solid ? materials.surface : materials.ghost,
      count,
    );
    this.#surface.instanceMatrix.setUsage(DynamicDrawUsage);
    this.#surface.instanceColor = new InstancedBufferAttribute(new Float32Array(count * 3), 3);
    this.#surface.castShadow = solid;
    this.#surface.receiveShadow = solid;
    this.#surface.frustumCulled = false;
    this.#edgeColours = new InstancedBufferAttribute(new Float32Array(count * 3), 3);
    this.#lines = new LineSegments(
      new InstancedBufferGeometry(),
      solid ? materials.lines : materials.ghostLines,
    );
    this.#lines.frustumCulled = false;
    this.#fillLineGeometry();
  }

  addTo(group: Group): void {
    group.add(this.#surface, this.#lines);
  }

  get detail(): DetailName {
    return this.#detail;
  }

  setDetail(detail: DetailName): void {
    const geometry = this.#library.get(this.partId, detail);
    if (detail === this.#detail || !geometry) {
      return;
    }
    this.#detail = detail;
    this.#surface.geometry = geometry.surface;
    this.#disposeLines();
    this.#lines.geometry = new InstancedBufferGeometry();
    this.#fillLineGeometry();
  }

  setLinesVisible(visible: boolean): void {
    this.#lines.visible = visible;
  }

  /** Places every instance; `shift` is added to a part's position (exploded views). */
  place(parts: readonly PlacedPart[], shift: (index: number) => Vec3): void {
    const matrix = new Matrix4();
    this.members.forEach((index, i) => {
      const part = parts[index];
      if (part) {
        this.#surface.setMatrixAt(i, partMatrix(matrix, part, shift(index)));
      }
    });
    this.#surface.instanceMatrix.needsUpdate = true;
  }

  /** Colours every instance with an sRGB value; edges follow. */
  paint(colourOf: (index: number) => number): void {
    const colour = new Color();
    const edges = this.#edgeColours;
    this.members.forEach((index, i) => {
      const hex = colourOf(index);
      this.#surface.setColorAt(i, colour.setHex(hex));
      colour.setHex(edgeHex(hex)).toArray(edges.array, i * 3);
    });
    if (this.#surface.instanceColor) {
      this.#surface.instanceColor.needsUpdate = true;
    }
    edges.needsUpdate = true;
  }

  dispose(): void {
    this.#surface.removeFromParent();
    this.#lines.removeFromParent();
    this.#surface.dispose();
    this.#disposeLines();
  }

  /** The lines' own geometry goes; the part's, which other batches share, stays. */
  #disposeLines(): void {
    for (const name of SHARED) {
      this.#lines.geometry.deleteAttribute(name);
    }
    this.#lines.geometry.dispose();
  }

  #fillLineGeometry(): void {
    const source = this.#library.get(this.partId, this.#detail)?.lines;
    const target = this.#lines.geometry;
    for (const name of SHARED) {
      const attribute = source?.getAttribute(name);
      if (attribute) {
        target.setAttribute(name, attribute);
      }
    }
    target.setAttribute('brickMatrix', this.#surface.instanceMatrix);
    target.setAttribute('brickColour', this.#edgeColours);
    target.instanceCount = this.members.length;
  }
}

/** The matrix that carries a part's own frame to its place. Writes into `target`. */
export function partMatrix(target: Matrix4, part: PlacedPart, shift: Vec3): Matrix4 {
  const r = part.rotation;
  const [x, y, z] = part.position;
  return target.set(
    r[0],
    r[1],
    r[2],
    x + shift[0],
    r[3],
    r[4],
    r[5],
    y + shift[1],
    r[6],
    r[7],
    r[8],
    z + shift[2],
    0,
    0,
    0,
    1,
  );
}
