// The four models that a new user draws first, with the pointer: table, house, seesaw, airplane.
import type { Page } from '@playwright/test';
import type { StandardView } from '../web/src/view/view-types.ts';
import { Camera, type Point } from './helpers/camera.ts';
import {
  begun,
  canvasPoint,
  clickPlaces,
  expect,
  expectLines,
  expectSketch,
  generate,
  openEmpty,
  runCommand,
  type Saved,
  savedSketch,
  settled,
  steadyBox,
  test,
} from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

/** So often the picture is made smaller, so that what is still to be drawn is in it. */
const ZOOMS = 4;

/**
 * Looks from a side at what is drawn, a little from afar.
 * @param lines so many are drawn by now.
 * @returns where points are on screen.
 */
async function lookFrom(page: Page, view: 'iso' | 'top', lines: number): Promise<Camera> {
  if (lines > 0) {
    await expectLines(page, lines);
  }
  const drawn = lines > 0 ? (await savedSketch(page)).lines : [];
  const shown = drawn.flatMap(({ from, to }) => [from, to]) as unknown as Point[];
  await page.keyboard.press(view === 'iso' ? 'i' : 't');
  await settled(page);
  for (let i = 0; i < ZOOMS; i++) {
    await page.keyboard.press('-');
  }
  await settled(page);
  return cameraOf(page, view, shown);
}

async function cameraOf(page: Page, view: StandardView, shown: readonly Point[]) {
  const box = await steadyBox(page.locator('.scene canvas'));
  return new Camera(view, shown, box, 1 / 1.25 ** ZOOMS);
}

/** Clicks points of space one after the other, and ends the chain. */
async function clickPoints(page: Page, camera: Camera, points: readonly Point[]): Promise<void> {
  await clickPlaces(
    page,
    points.map((point) => camera.at(point)),
  );
  await page.keyboard.press('Escape');
}

/** Undoes everything, then does everything again, with a reload in between. */
async function thereAndBack(page: Page): Promise<void> {
  const before = (await savedSketch(page)).lines;
  const undo = page.getByRole('button', { name: 'Undo' });
  await expect(async () => {
    await page.keyboard.press('Control+z');
    await expect(undo).toBeDisabled({ timeout: 50 });
  }).toPass({ intervals: [0] });
  await page.reload();
  await begun(page);
  const redo = page.getByRole('button', { name: 'Redo' });
  await expect(redo).toBeEnabled();
  await expect(async () => {
    await page.keyboard.press('Control+Shift+z');
    await expect(redo).toBeDisabled({ timeout: 50 });
  }).toPass({ intervals: [0] });
  await expectSketch(page, ({ lines }) => lines, before);
}

test('a table: a rectangle and four legs of a typed length', async ({ page }) => {
  await openEmpty(page);
  const above = await lookFrom(page, 'top', 0);
  await page.keyboard.press('r');
  await clickPlaces(page, [above.at([-4, -2, 0]), above.at([4, 2, 0])]);
  const corner = await lookFrom(page, 'iso', 4);
  await page.keyboard.press('l');
  for (const foot of [
    [-4, -2, 0],
    [4, -2, 0],
    [4, 2, 0],
    [-4, 2, 0],
  ] as const) {
    await clickPlaces(page, [corner.at(foot)]);
    const down = await canvasPoint(page, ...corner.at([foot[0], foot[1], -2]));
    await page.mouse.move(down.x, down.y);
    await page.keyboard.type('5');
    await page.keyboard.press('Enter');
    await page.keyboard.press('Escape');
  }
  await expectSketch(page, ({ lines }) => lines.slice(4).map(({ to }) => to[2]), [-5, -5, -5, -5]);
  await generate(page);
  await expect(page.getByTestId('verdict')).toContainText('Buildable');
  await thereAndBack(page);
});

test('a house whose roof is made of 3-4-5 triangles', async ({ page }) => {
  await openEmpty(page);
  const ground = await lookFrom(page, 'iso', 0);
  await page.keyboard.press('b');
  await clickPlaces(page, [ground.at([-3, -3, 0]), ground.at([3, 3, 0]), ground.at([3, 3, 4])]);
  const camera = await lookFrom(page, 'iso', 12);
  await page.keyboard.press('l');
  await runCommand(page, 'plane upright ZX');
  for (const y of [-3, 3]) {
    await clickPoints(page, camera, [
      [-3, y, 4],
      [0, y, 8],
      [3, y, 4],
    ]);
  }
  await clickPoints(page, camera, [
    [0, -3, 8],
    [0, 3, 8],
  ]);
  const roof = ({ lines }: Saved) =>
    lines.slice(12).map(({ from, to }) => Math.hypot(...from.map((v, k) => v - (to[k] ?? 0))));
  await expectSketch(page, roof, [5, 5, 5, 5, 6]);
});

test('a seesaw that turns about a joint', async ({ page }) => {
  await openEmpty(page);
  const ground = await lookFrom(page, 'iso', 0);
  await page.keyboard.press('l');
  await clickPoints(page, ground, [
    [-4, 0, 0],
    [4, 0, 0],
  ]);
  await clickPoints(page, ground, [
    [0, -4, 0],
    [0, 4, 0],
  ]);
  await clickPoints(page, ground, [
    [0, 0, 0],
    [0, 0, 5],
  ]);
  const camera = await lookFrom(page, 'iso', 3);
  await page.keyboard.press('l');
  await runCommand(page, 'plane upright ZX');
  await clickPoints(page, camera, [
    [0, 0, 5],
    [6, 0, 5],
  ]);
  await clickPoints(page, camera, [
    [0, 0, 5],
    [-6, 0, 5],
  ]);
  await page.keyboard.press('v');
  const [left, right] = [camera.at([-3, 0, 5]), camera.at([3, 0, 5])];
  await clickPlaces(page, [right]);
  await page.keyboard.down('Shift');
  await clickPlaces(page, [left]);
  await page.keyboard.up('Shift');
  await runCommand(page, 'join lines');
  await page.keyboard.press('j');
  await clickPlaces(page, [camera.at([0, 0, 5])]);
  await expectLines(page, 4);
  await expectSketch(page, ({ joints }) => joints?.[0]?.axis.map(Math.abs), [0, 1, 0]);
});

test('an airplane of which one half is drawn and mirrored', async ({ page }) => {
  await openEmpty(page);
  const above = await lookFrom(page, 'top', 0);
  await page.keyboard.press('l');
  await clickPoints(page, above, [
    [0, -5, 0],
    [0, 5, 0],
  ]);
  await clickPoints(page, above, [
    [0, 3, 0],
    [6, 3, 0],
    [6, 1, 0],
    [0, 1, 0],
  ]);
  await clickPoints(page, above, [
    [0, -4, 0],
    [3, -4, 0],
  ]);
  await page.keyboard.press('v');
  const from = await canvasPoint(page, ...above.at([7, 4.5, 0]));
  const to = await canvasPoint(page, ...above.at([-0.5, -4.6, 0]));
  await page.keyboard.down('Shift');
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 3 });
  await page.mouse.up();
  await page.keyboard.up('Shift');
  await page.keyboard.press('m');
  await expectLines(page, 9);
  const ends = ({ lines }: Saved) => {
    const xs = lines.flatMap(({ from: a, to: b }) => [a[0] ?? 0, b[0] ?? 0]);
    return [Math.min(...xs), Math.max(...xs)];
  };
  await expectSketch(page, ends, [-6, 6]);
  // The program finds the mirror plane, and a click keeps it.
  await page.getByRole('heading', { name: 'Symmetry' }).click();
  await page.getByRole('checkbox', { name: 'Mirror at x = 0 found' }).click();
  await expectSketch(page, ({ symmetries }) => symmetries, [
    { kind: 'reflection', normal: [1, 0, 0], offset: 0 },
  ]);
});

test('a corner that is dragged takes its side along', async ({ page }) => {
  await openEmpty(page);
  const above = await lookFrom(page, 'top', 0);
  await page.keyboard.press('r');
  await clickPlaces(page, [above.at([-4, -2, 0]), above.at([4, 2, 0])]);
  await page.keyboard.press('v');
  const from = await canvasPoint(page, ...above.at([4, 2, 0]));
  const to = await canvasPoint(page, ...above.at([7, 2, 0]));
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 3 });
  await page.mouse.up();
  const xs = ({ lines }: Saved) =>
    [...new Set(lines.flatMap(({ from: a, to: b }) => [a[0] ?? 0, b[0] ?? 0]))].sort(
      (a, b) => a - b,
    );
  await expectSketch(page, xs, [-4, 7]);
  await page.keyboard.press('Control+z');
  await expectSketch(page, xs, [-4, 4]);
});
