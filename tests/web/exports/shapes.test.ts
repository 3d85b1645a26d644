import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type Validation, validateBytes } from 'gltf-validator';
import { describe, expect, it } from 'vitest';
import { mendsOf } from '../../../scripts/lib/admesh.mjs';
import { IDENTITY, type Mat3 } from '../../../web/src/geometry/vec.ts';
import type { Model } from '../../../web/src/model/model.ts';
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
  readonly nodes: { readonly mesh?: number; readonly translation?: number[] }[];
  readonly meshes?: unknown[];
  readonly materials?: unknown[];
  readonly accessors?: unknown[];
}

/** What the reference validator of the format says, and the file's JSON. */
async function readGlb(file: Uint8Array): Promise<{ said: Validation; json: Gltf }> {
  const said = await validateBytes(file);
  const length = new DataView(file.buffer, file.byteOffset).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + length))) as Gltf;
  return { said, json };
}

describe('.glb', () => {
  it('stores each part once and places it by nodes', async () => {
    const { said, json } = await readGlb(
      await writeGlb(
        modelOf([
          ['32316', 71, 0],
          ['32316', 71, 3],
          ['32316', 0, 6],
        ]),
        shelf,
      ),
    );
    expect(said.info.version).toBe('2.0');
    expect(said.issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
    expect(json.nodes).toHaveLength(4);
    expect(json.meshes).toHaveLength(2);
    expect(json.materials).toHaveLength(2);
    expect(json.accessors).toHaveLength(3);
    expect(json.nodes.map(({ translation }) => translation?.[0] ?? 0).sort()).toEqual([0, 0, 3, 6]);
  });

  it('is a scene without parts for an empty model', async () => {
    const { said, json } = await readGlb(await writeGlb(modelOf([]), shelf));
    expect(said.issues.numErrors).toBe(0);
    expect(json.nodes).toHaveLength(1);
  });

  it('has every part of the catalogue, and the validator of the format finds no fault', async () => {
    const rows = catalogue.parts.map(({ id, color }, i) => [id, color, 20 * i] as const);
    const { said } = await readGlb(await writeGlb(modelOf(rows), shelf));
    expect(said.issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
    expect(said.info.totalTriangleCount).toBeGreaterThan(1000);
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

  it('is closed byte by byte for every part of the catalogue, however it is turned', () => {
    const turned: Mat3 = [0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1];
    for (const { id } of catalogue.parts) {
      const model = modelOf([[id, 71, 1 / 3]]);
      const parts = model.parts.map((part) => ({ ...part, rotation: turned }));
      expect(openBytes(writeStl({ ...model, parts }, shelf)), id).toBe(0);
    }
  });

  it('has nothing that admesh would mend', () => {
    const rows = catalogue.parts.map(({ id }, i) => [id, 71, 20 * i + 1 / 3] as const);
    const folder = mkdtempSync(join(tmpdir(), 'liftarm-stl-'));
    const path = join(folder, 'all.stl');
    try {
      writeFileSync(path, writeStl(modelOf(rows), shelf));
      expect(mendsOf(path)).toEqual([]);
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
});

/** Edges whose corners are not, byte by byte, those of as many edges the other way. */
function openBytes(file: Uint8Array): number {
  const text = (at: number) => Buffer.from(file.subarray(at, at + 12)).toString('hex');
  const balance = new Map<string, number>();
  for (let face = 84; face < file.length; face += 50) {
    const corners = [12, 24, 36].map((offset) => text(face + offset));
    corners.forEach((from, k) => {
      const to = corners[(k + 1) % 3] ?? '';
      const [name, way] = from < to ? [from + to, 1] : [to + from, -1];
      balance.set(name, (balance.get(name) ?? 0) + way);
    });
  }
  return [...balance.values()].filter((sum) => sum !== 0).length;
}

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
