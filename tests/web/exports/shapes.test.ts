import { describe, expect, it } from 'vitest';
import type { Model } from '../../../web/src/model/model.ts';
import { IDENTITY } from '../../../web/src/geometry/vec.ts';
import { embedHtml, linkTo, pageFolder } from '../../../web/src/ui/share/page-link.ts';
import { MAX_QR_BYTES, qrPath } from '../../../web/src/ui/share/qr-code.tsx';
import { MeshShelf } from '../../../web/src/view/drawing/drawn-part.ts';
import { writeGlb } from '../../../web/src/view/export/glb.ts';
import { writeStl } from '../../../web/src/view/export/stl.ts';
import { catalogue } from '../view/helpers/catalogue.ts';

const shelf = new MeshShelf(catalogue);

function modelOf(rows: readonly (readonly [string, number, number])[]): Model {
  return {
    name: 'Two',
    parts: rows.map(([part, color, x]) => ({
      part,
      color,
      position: [x, 0, 0],
      rotation: IDENTITY,
      component: -1,
      layer: 0,
      piece: 0,
    })),
  };
}

interface Gltf {
  readonly asset: { readonly version: string };
  readonly nodes: { readonly mesh?: number; readonly matrix: number[] }[];
  readonly meshes: { readonly primitives: { readonly indices: number }[] }[];
  readonly materials: unknown[];
  readonly accessors: { readonly count: number; readonly max?: number[] }[];
  readonly buffers: { readonly byteLength: number }[];
}

function readGlb(file: Uint8Array): { readonly json: Gltf; readonly binary: number } {
  const view = new DataView(file.buffer);
  expect(view.getUint32(0, true)).toBe(0x46546c67);
  expect(view.getUint32(8, true)).toBe(file.length);
  const length = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + length))) as Gltf;
  const more = file.length > 20 + length;
  return { json, binary: more ? view.getUint32(20 + length, true) : 0 };
}

describe('.glb', () => {
  it('stores each part once and places it by nodes', () => {
    const { json, binary } = readGlb(
      writeGlb(
        modelOf([
          ['32316', 71, 0],
          ['32316', 71, 3],
          ['32316', 0, 6],
        ]),
        shelf,
      ),
    );
    expect(json.asset.version).toBe('2.0');
    expect(json.nodes).toHaveLength(4);
    expect(json.meshes).toHaveLength(2);
    expect(json.materials).toHaveLength(2);
    expect(json.accessors).toHaveLength(3);
    expect(json.nodes[1]?.matrix.slice(12, 15)).toEqual([3, 0, 0]);
    expect(json.buffers[0]?.byteLength).toBeLessThanOrEqual(binary);
  });

  it('is a scene without parts for an empty model', () => {
    const { json } = readGlb(writeGlb(modelOf([]), shelf));
    expect(json.nodes).toHaveLength(1);
  });
});

describe('.stl', () => {
  it('holds all triangles in millimetres', () => {
    const file = writeStl(modelOf([['32316', 71, 10]]), shelf);
    const view = new DataView(file.buffer);
    const count = view.getUint32(80, true);
    expect(file.length).toBe(84 + 50 * count);
    const xs = Array.from({ length: count }, (_, i) => view.getFloat32(84 + 50 * i + 12, true));
    expect(Math.min(...xs)).toBeCloseTo(80 - 3.6, 1);
    expect(Math.max(...xs)).toBeCloseTo(80 + 3.6, 1);
  });
});

describe('links and codes', () => {
  it('work in any folder', () => {
    expect(pageFolder('https://a.example/x/y/?room=share#s1.a.b')).toBe('https://a.example/x/y/');
  });

  it('keep markup of a name out of the embedding', async () => {
    const sketch = { format: 'technic-sketch', version: 1, lines: [] } as const;
    const link = await linkTo({ sketch, preset: 'simple', seed: 1 }, 'https://a.example/x/');
    const html = embedHtml(link.ok ? link.value : '', '"><script>');
    expect(html).toContain('src="https://a.example/x/embed.html#s2.');
    expect(html).not.toContain('<script>');
  });

  it('have a QR code up to its limit, and none beyond', () => {
    expect(qrPath('x'.repeat(MAX_QR_BYTES))?.size).toBe(177 + 8);
    expect(qrPath('x'.repeat(MAX_QR_BYTES + 1))).toBeNull();
  });
});
