import { bytesOf, openModelRoom } from './helpers/rooms.ts';
import { expect, test } from './helpers/test.ts';

test.use({ draws: false });

/** The button's words, and how the file must begin or what it must hold. */
const TEXT_FILES = [
  ['LDraw model (.mpd)', /^0 FILE Square frame\.ldr\n[\s\S]*32524\.dat|40490\.dat/],
  ['Rebrickable parts list', /^Part,Color,Quantity\n\w+,\d+,4\n/],
  ['BrickLink wanted list', /^<INVENTORY>\n<ITEM><ITEMTYPE>P<\/ITEMTYPE><ITEMID>\w+/],
  ['Table (.csv)', /^Name,Number,Colour,Count,[\s\S]*\nSum,,,8,/],
  ['Line drawing (.svg)', /^<svg [\s\S]*<title>Square frame<\/title><path d="M/],
  ['Sketch (.json)', /"technic-sketch"/],
  ['Model (.json)', /"liftarm-model"/],
] as const;

test('every file of a model is written', async ({ page }) => {
  await openModelRoom(page, 'share', 'examples/square-frame');
  const press = (words: string) => page.getByRole('button', { name: words }).click();
  for (const [words, content] of TEXT_FILES) {
    const file = await bytesOf(page, () => press(words));
    expect(file.toString('utf8'), words).toMatch(content);
    await expect(page.locator('.share-said')).toContainText('downloaded');
  }
  const glb = await bytesOf(page, () => press('3D scene (.glb)'));
  expect(glb.subarray(0, 4).toString('latin1')).toBe('glTF');
  expect(glb.readUInt32LE(8)).toBe(glb.length);
  const stl = await bytesOf(page, () => press('Surfaces (.stl)'));
  expect(stl.length).toBe(84 + 50 * stl.readUInt32LE(80));
  const png = await bytesOf(page, () => press('Picture (.png)'));
  expect(png.subarray(1, 4).toString('latin1')).toBe('PNG');
  // Colour type 6: with an alpha channel, so the ground can be transparent.
  expect(png[25]).toBe(6);
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
