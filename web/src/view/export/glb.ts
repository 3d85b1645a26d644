import {
  type Accessor,
  type Buffer,
  ColorUtils,
  Document,
  type mat4,
  type vec4,
  WebIO,
} from '@gltf-transform/core';
import { colourHex, colourName } from '../../model/colours.ts';
import type { Model, PlacedPart } from '../../model/model.ts';
import type { BrickMesh } from '../bricks/mesh-builder.ts';
import type { MeshShelf } from '../drawing/drawn-part.ts';

const METRES_PER_MODULE = 0.008;
const S = METRES_PER_MODULE;
/** glTF is Y up in metres: (x, y, z) modules become (x, z, -y). */
const TO_GLTF: mat4 = [S, 0, 0, 0, 0, 0, -S, 0, 0, S, 0, 0, 0, 0, 0, 1];

/**
 * The model as a .glb file (glTF 2.0). Each part's mesh is stored once and placed by nodes; a part in two
 * colours is two meshes on the same numbers. Parts that the catalogue does not know are left out.
 */
export async function writeGlb(model: Model, shelf: MeshShelf): Promise<Uint8Array<ArrayBuffer>> {
  const document = new Document();
  const buffer = document.createBuffer();
  const name = model.name || 'Model';
  const shapes = new Map<string, Shape>();
  const materials = new Map<number, ReturnType<typeof addMaterial>>();
  const meshes = new Map<string, ReturnType<Document['createMesh']>>();
  const whole = document.createNode(name).setMatrix(TO_GLTF);
  document.createScene(name).addChild(whole);
  for (const [index, placed] of model.parts.entries()) {
    const mesh = shelf.get(placed.part, 'high');
    if (!mesh) {
      continue;
    }
    const shape = remember(shapes, placed.part, () => addShape(document, buffer, mesh));
    const material = remember(materials, placed.color, () => addMaterial(document, placed.color));
    const coloured = remember(meshes, `${placed.part}/${placed.color}`, () =>
      document
        .createMesh(placed.part)
        .addPrimitive(
          document
            .createPrimitive()
            .setAttribute('POSITION', shape.positions)
            .setAttribute('NORMAL', shape.normals)
            .setIndices(shape.indices)
            .setMaterial(material),
        ),
    );
    whole.addChild(
      document
        .createNode(`${index + 1} ${placed.part}`)
        .setMesh(coloured)
        .setMatrix(matrixOf(placed)),
    );
  }
  if (meshes.size === 0) {
    buffer.dispose(); // glTF knows no empty buffer
  }
  const file = await new WebIO().writeBinary(document);
  return file as Uint8Array<ArrayBuffer>;
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

interface Shape {
  readonly positions: Accessor;
  readonly normals: Accessor;
  readonly indices: Accessor;
}

function addShape(document: Document, buffer: Buffer, mesh: BrickMesh): Shape {
  const numbers = (type: 'SCALAR' | 'VEC3', array: Float32Array | Uint32Array) =>
    document
      .createAccessor()
      .setType(type)
      .setArray(array as Float32Array<ArrayBuffer>)
      .setBuffer(buffer);
  return {
    positions: numbers('VEC3', mesh.positions),
    normals: numbers('VEC3', mesh.normals),
    indices: numbers('SCALAR', mesh.indices),
  };
}

function addMaterial(document: Document, code: number) {
  const colour: vec4 = [0, 0, 0, 1];
  ColorUtils.hexToFactor(colourHex(code), colour);
  return document
    .createMaterial(colourName(code))
    .setBaseColorFactor(colour)
    .setMetallicFactor(0)
    .setRoughnessFactor(0.45);
}

/** Column by column, as glTF wants it. */
function matrixOf({ rotation: r, position: p }: PlacedPart): mat4 {
  return [r[0], r[3], r[6], 0, r[1], r[4], r[7], 0, r[2], r[5], r[8], 0, p[0], p[1], p[2], 1];
}
