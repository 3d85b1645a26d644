import { validateBytes } from 'gltf-validator';
import { catalogue } from '../tests/web/view/helpers/catalogue.ts';
import type { PlacedPart } from '../web/src/model/model.ts';
import { readMpd } from '../web/src/share/read-mpd.ts';
import { nativeCheck } from './helpers/native.ts';
import { readImage, readStl, readXml, solveDeck } from './helpers/readers.ts';
import { bytesOf, openModelRoom } from './helpers/rooms.ts';
import { expect, test } from './helpers/test.ts';

test.use({ draws: false });

/** Beams of a square frame of eight modules, and four pins; millimetres. */
const PARTS = 8;
const SIDE = 9 * 8;

test('every file of a model is written, and others can read it', async ({ page }) => {
  await openModelRoom(page, 'share', 'examples/square-frame');
  const written = async (words: string) => {
    const file = await bytesOf(page, () => page.getByRole('button', { name: words }).click());
    await expect(page.locator('.share-said')).toContainText('downloaded');
    return file;
  };
  const textOf = async (words: string) => (await written(words)).toString('utf8');

  const model = await textOf('Model (.json)');
  expect(JSON.parse(model)).toMatchObject({ format: 'liftarm-model' });
  const check = nativeCheck(model);
  expect(check, check.words).toMatchObject({ code: 0 });
  const sketch = JSON.parse(await textOf('Sketch (.json)')) as { format: string; lines: unknown[] };
  expect(sketch).toMatchObject({ format: 'technic-sketch' });
  expect(sketch.lines).toHaveLength(4);

  const mpd = await textOf('LDraw model (.mpd)');
  expect(mpd).toMatch(/^0 FILE Square frame\.ldr\r?\n/);
  const read = readMpd(mpd, catalogue);
  const again = JSON.parse(read.ok ? read.value : '{}') as { parts?: PlacedPart[] };
  const names = (text: string) =>
    (JSON.parse(text) as { parts: PlacedPart[] }).parts.map(({ part }) => part).sort();
  expect(again.parts?.map(({ part }) => part).sort()).toEqual(names(model));

  const rows = (await textOf('Rebrickable parts list')).trim().split('\n');
  expect(rows[0]).toBe('Part,Color,Quantity');
  expect(rows.slice(1).every((row) => /^\w+,\d+,\d+$/.test(row))).toBe(true);
  expect(rows.slice(1).reduce((sum, row) => sum + Number(row.split(',')[2]), 0)).toBe(PARTS);
  const wanted = await readXml(page, await written('BrickLink wanted list'));
  expect(wanted).toMatchObject({ INVENTORY: 1, ITEM: rows.length - 1, COLOR: rows.length - 1 });
  const table = await textOf('Table (.csv)');
  expect(table).toMatch(/^Name,Number,Colour,Count,[\s\S]*\nSum,,,8,/);

  const { info, issues } = await validateBytes(await written('3D scene (.glb)'));
  expect(issues).toMatchObject({ numErrors: 0, numWarnings: 0 });
  const stl = readStl(await written('Surfaces (.stl)'));
  // Four beams and four pins, each stored once in the one file.
  expect(stl.triangles).toBe(4 * info.totalTriangleCount);
  expect(stl.volume).toBeGreaterThan(PARTS * 100);
  // Three millimetres for the play between bricks, and for layers.
  expect(Math.abs(Math.max(...stl.size) - SIDE)).toBeLessThan(3);
  const png = await readImage(page, await written('Picture (.png)'), 'image/png');
  expect(png).toMatchObject({ width: 2000, height: 1500 });
  expect(png.clear).toBeGreaterThan(0.3);
  expect(png.solid).toBeGreaterThan(0.05);
  const svg = await readXml(page, await written('Line drawing (.svg)'));
  expect(svg).toMatchObject({ svg: 1, title: 1 });
  expect(svg['path']).toBeGreaterThan(0);

  const said = solveDeck(await written('CalculiX deck (.inp)'));
  expect(said).toContain('Job finished');
  expect(said).not.toContain('*ERROR');
  const script = await textOf('ANSYS script (.apdl)');
  expect(script).toMatch(/\/PREP7[\s\S]*\/SOLU\nANTYPE,STATIC\nSOLVE\n/);
  expect(script).not.toMatch(/nan|inf/i);
  const nodes = new Set([...script.matchAll(/^N,(\d+),/gm)].map((match) => match[1]));
  const elements = [...script.matchAll(/^E,(.+)$/gm)].map((match) => (match[1] ?? '').split(','));
  expect(elements.length).toBeGreaterThan(PARTS);
  expect(elements.flat().filter((node) => !nodes.has(node))).toEqual([]);
});

test('without a model only the sketch can be written', async ({ page }) => {
  await page.addInitScript(() => {
    localStorage.setItem('liftarm/preferences', JSON.stringify({ autoSolve: false }));
  });
  await page.goto('./?room=share');
  await expect(page.getByText('Generate the model first')).toBeVisible();
  await expect(page.getByRole('button', { name: 'LDraw model' })).toBeDisabled();
  await expect(page.getByRole('button', { name: 'Sketch (.json)' })).toBeEnabled();
});
