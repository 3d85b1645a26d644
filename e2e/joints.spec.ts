// Joints that a person controls: axis, sides and range by pointer, finger, keys and typed numbers.
import type { Page } from '@playwright/test';
import type { SketchJoint } from '../web/src/model/sketch.ts';
import { expectAccessible } from './helpers/axe.ts';
import { Camera, type Point } from './helpers/camera.ts';
import {
  canvasPoint,
  expect,
  openEmpty,
  openText,
  savedSketch,
  settled,
  test,
} from './helpers/test.ts';

test.use({ draws: false });

const STAR: readonly { from: Point; to: Point }[] = [
  { from: [0, 0, 0], to: [8, 0, 0] },
  { from: [0, 0, 0], to: [0, 6, 0] },
  { from: [-6, 0, 0], to: [0, 0, 0] },
];
/** Of the ring on screen, pixels. */
const RING = 62;

const card = (page: Page) => page.locator('.joint-card');

async function openStar(page: Page): Promise<void> {
  await openEmpty(page);
  await openText(page, JSON.stringify({ format: 'technic-sketch', version: 1, lines: STAR }));
  await expect(page.getByRole('button', { name: /^Generate/ })).toBeEnabled();
  await page.keyboard.press('t');
  await settled(page);
}

async function jointsOf(page: Page): Promise<readonly SketchJoint[]> {
  const sketch = (await savedSketch(page)) as unknown as { joints?: readonly SketchJoint[] };
  return sketch.joints ?? [];
}

/** Where a point of space is on the page, from straight above. */
async function placeOf(page: Page, point: Point): Promise<{ x: number; y: number }> {
  const box = await page.locator('.scene canvas').boundingBox();
  const points = STAR.flatMap(({ from, to }) => [from, to]);
  const camera = new Camera('top', points, box ?? { width: 1, height: 1 });
  return canvasPoint(page, ...camera.at(point));
}

async function clickAt(page: Page, point: Point): Promise<void> {
  const { x, y } = await placeOf(page, point);
  await page.mouse.move(x, y);
  await page.mouse.click(x, y);
}

test('a joint is set, told what moves, turned and given a range by the pointer', async ({
  page,
}) => {
  await openStar(page);
  await page.keyboard.press('j');
  await clickAt(page, [0, 0, 0]);
  await expect(card(page)).toContainText('Joint 1');
  await clickAt(page, [5.5, 0, 0]);
  await expect(card(page).getByRole('button', { name: /^Line 1: body 2/ })).toBeVisible();
  // The ring counts from the first line of the second body, which runs along x now.
  const middle = await placeOf(page, [0, 0, 0]);
  const onRing = (degrees: number) => ({
    x: middle.x + RING * Math.cos((degrees * Math.PI) / 180),
    y: middle.y - RING * Math.sin((degrees * Math.PI) / 180),
  });
  const drag = async (degrees: readonly number[]) => {
    for (const [i, each] of degrees.entries()) {
      const { x, y } = onRing(each);
      await page.mouse.move(x, y, { steps: 3 });
      if (i === 0) {
        await page.mouse.down();
      }
    }
    await page.mouse.up();
  };
  await drag([16, 40, 90]);
  await expect(page.getByLabel('To, degrees')).toHaveValue('90');
  await drag([0, -30]);
  await expect(page.getByLabel('From, degrees')).toHaveValue('-30');
  await page.keyboard.press('Control+z');
  await expect(page.getByLabel('From, degrees')).toHaveValue('0');
  expect((await jointsOf(page))[0]).toMatchObject({
    between: [[2], [0, 1]],
    range: [0, 90],
  });
});

test('a joint can be had from the keyboard alone', async ({ page }) => {
  await openStar(page);
  await page.locator('.scene canvas').focus();
  await page.keyboard.press('j');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await expect(card(page)).toBeVisible();
  await page.keyboard.press('x');
  await expect(card(page).getByRole('button', { name: /^X/ })).toHaveAttribute(
    'aria-pressed',
    'true',
  );
  // Lines 1 and 3 lie along x: about it they would turn about themselves.
  await expect(card(page).getByRole('button', { name: /^X/ })).toHaveAccessibleName(
    'X, about line 1, 3 itself',
  );
  await page.keyboard.press('z');
  await page.keyboard.press('1');
  await page.keyboard.press('1');
  await expect(card(page).getByRole('button', { name: /^Line 1: body 3/ })).toBeVisible();
  await page.getByRole('button', { name: 'Full turn' }).press('Enter');
  expect(await jointsOf(page)).toEqual([
    { at: [0, 0, 0], axis: [0, 0, 1], between: [[2], [1], [0]], range: [-180, 180] },
  ]);
  await page.locator('.scene canvas').focus();
  await page.keyboard.press('Delete');
  await expect(card(page)).toBeHidden();
  expect(await jointsOf(page)).toEqual([]);
});

test('joints that cannot be had together are said at once, with the reason', async ({ page }) => {
  await openStar(page);
  await page.keyboard.press('j');
  await clickAt(page, [0, 0, 0]);
  await page.getByRole('button', { name: 'One more joint here' }).click();
  await expect(card(page)).toContainText('2 of 2 here');
  await expect(card(page).getByRole('alert')).toHaveText('');
  await card(page).getByRole('button', { name: /^Y/ }).click();
  await expect(card(page).getByRole('alert')).toContainText('cannot turn about two axes');
  await card(page).getByRole('button', { name: 'Remove the joint' }).click();
  await clickAt(page, [0, 0, 0]);
  await expect(card(page)).not.toContainText('2 of 2 here');
  await expect(card(page).getByRole('alert')).toHaveText('');
});

test('the joint of a model is changed from where it moves', async ({ page }) => {
  await openEmpty(page);
  const joints = [{ at: [0, 0, 0], axis: [0, 0, 1], between: [[0], [1]] }];
  const lines = STAR.slice(0, 2);
  await openText(page, JSON.stringify({ format: 'technic-sketch', version: 1, lines, joints }));
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 90_000 });
  await page.getByRole('link', { name: 'Move' }).click();
  await page.getByRole('button', { name: 'Change joint 1' }).click();
  await expect(card(page)).toContainText('Joint 1');
  await expectAccessible(page, 'a joint that is being changed');
});
