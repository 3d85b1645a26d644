import { colourHex, colourName } from '../../model/colours.ts';
import type { Model, PlacedPart } from '../../model/model.ts';
import type { BrickMesh } from '../bricks/mesh-builder.ts';
import type { MeshShelf } from '../drawing/drawn-part.ts';

// glTF 2.0 as one binary file (.glb). Each part's mesh is stored once and placed by nodes; a part in
// two colours is two meshes on the same numbers. glTF is Y up in metres: one node turns and scales all.

const METRES_PER_MODULE = 0.008;
const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;
const FLOAT = 5126;
const UNSIGNED_INT = 5125;
const ARRAY_BUFFER = 34962;
const ELEMENT_ARRAY_BUFFER = 34963;

interface Accessor {
  readonly bufferView: number;
  readonly componentType: number;
  readonly count: number;
  readonly type: 'SCALAR' | 'VEC3';
  readonly min?: number[];
  readonly max?: number[];
}

/** Collects the numbers of all meshes behind each other. */
class BinaryPart {
  readonly views: object[] = [];
  readonly accessors: Accessor[] = [];
  readonly chunks: Uint8Array[] = [];
  length = 0;

  add(numbers: Float32Array | Uint32Array, width: 1 | 3, bounds: boolean): number {
    const bytes = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
    const indices = numbers instanceof Uint32Array;
    this.views.push({
      buffer: 0,
      byteOffset: this.length,
      byteLength: bytes.length,
      target: indices ? ELEMENT_ARRAY_BUFFER : ARRAY_BUFFER,
    });
    this.chunks.push(bytes);
    this.length += bytes.length;
    this.accessors.push({
      bufferView: this.views.length - 1,
      componentType: indices ? UNSIGNED_INT : FLOAT,
      count: numbers.length / width,
      type: width === 3 ? 'VEC3' : 'SCALAR',
      ...(bounds ? extremes(numbers) : {}),
    });
    return this.accessors.length - 1;
  }
}

function extremes(numbers: Float32Array | Uint32Array): { min: number[]; max: number[] } {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  numbers.forEach((value, i) => {
    min[i % 3] = Math.min(min[i % 3] ?? value, value);
    max[i % 3] = Math.max(max[i % 3] ?? value, value);
  });
  return { min, max };
}

/** The model as a .glb file. Parts that the catalogue does not know are left out. */
export function writeGlb(model: Model, shelf: MeshShelf): Uint8Array<ArrayBuffer> {
  const binary = new BinaryPart();
  const geometry = new Map<string, { attributes: object; indices: number }>();
  const materials = new Map<number, number>();
  const meshes = new Map<string, number>();
  const meshRows: object[] = [];
  const nodes: object[] = [];
  for (const [index, placed] of model.parts.entries()) {
    const mesh = shelf.get(placed.part, 'high');
    if (!mesh) {
      continue;
    }
    const shape = remember(geometry, placed.part, () => addMesh(binary, mesh));
    const material = remember(materials, placed.color, () => materials.size);
    const row = remember(meshes, `${placed.part}/${placed.color}`, () => {
      meshRows.push({ name: placed.part, primitives: [{ ...shape, material }] });
      return meshRows.length - 1;
    });
    nodes.push({ name: `${index + 1} ${placed.part}`, mesh: row, matrix: matrixOf(placed) });
  }
  const root = nodes.length;
  const all = nodes.map((_, i) => i);
  const s = METRES_PER_MODULE;
  // Z up to Y up: (x, y, z) becomes (x, z, -y).
  const turn = [s, 0, 0, 0, 0, 0, -s, 0, 0, s, 0, 0, 0, 0, 0, 1];
  const children = all.length > 0 ? { children: all } : {};
  nodes.push({ name: model.name || 'Model', ...children, matrix: turn });
  return pack(
    {
      asset: { version: '2.0', generator: 'Liftarm' },
      scene: 0,
      scenes: [{ name: model.name || 'Model', nodes: [root] }],
      nodes,
      ...(meshRows.length > 0
        ? {
            meshes: meshRows,
            materials: [...materials.keys()].map(materialOf),
            accessors: binary.accessors,
            bufferViews: binary.views,
            buffers: [{ byteLength: binary.length }],
          }
        : {}),
    },
    binary,
  );
}

function remember<K, V>(map: Map<K, V>, key: K, make: () => V): V {
  const known = map.get(key);
  if (known !== undefined) {
    return known;
  }
  const made = make();
  map.set(key, made);
  return made;
}

function addMesh(binary: BinaryPart, mesh: BrickMesh): { attributes: object; indices: number } {
  return {
    attributes: {
      POSITION: binary.add(mesh.positions, 3, true),
      NORMAL: binary.add(mesh.normals, 3, false),
    },
    indices: binary.add(mesh.indices, 1, false),
  };
}

function materialOf(code: number): object {
  const hex = colourHex(code);
  const linear = (shift: number) => {
    const value = ((hex >> shift) & 0xff) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  };
  return {
    name: colourName(code),
    pbrMetallicRoughness: {
      baseColorFactor: [linear(16), linear(8), linear(0), 1],
      metallicFactor: 0,
      roughnessFactor: 0.45,
    },
  };
}

/** Column by column, as glTF wants it. */
function matrixOf({ rotation: r, position: p }: PlacedPart): number[] {
  return [r[0], r[3], r[6], 0, r[1], r[4], r[7], 0, r[2], r[5], r[8], 0, p[0], p[1], p[2], 1];
}

function pack(json: object, binary: BinaryPart): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const textLength = Math.ceil(text.length / 4) * 4;
  const binaryLength = Math.ceil(binary.length / 4) * 4;
  const hasBinary = binary.length > 0;
  const total = 12 + 8 + textLength + (hasBinary ? 8 + binaryLength : 0);
  const file = new Uint8Array(total);
  const view = new DataView(file.buffer);
  [MAGIC, 2, total, textLength, JSON_CHUNK].forEach((value, i) => {
    view.setUint32(4 * i, value, true);
  });
  file.fill(0x20, 20, 20 + textLength);
  file.set(text, 20);
  if (hasBinary) {
    let at = 20 + textLength;
    view.setUint32(at, binaryLength, true);
    view.setUint32(at + 4, BINARY_CHUNK, true);
    at += 8;
    for (const chunk of binary.chunks) {
      file.set(chunk, at);
      at += chunk.length;
    }
  }
  return file;
}
