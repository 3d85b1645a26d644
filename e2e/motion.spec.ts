// What moves: played, several joints at once.
import type { Page } from '@playwright/test';
import { Camera } from './helpers/camera.ts';
import { countFrames } from './helpers/readers.ts';
import {
  downloaded,
  expect,
  openEmpty,
  openText,
  settled,
  steadyBox,
  test,
} from './helpers/test.ts';

test.use({ draws: false });

/** A rail with an arm at either end. */
const ARMS = JSON.stringify({
  format: 'technic-sketch',
  version: 1,
  name: 'Two arms',
  lines: [
    { from: [0, 0, 0], to: [10, 0, 0] },
    { from: [0, 0, 0], to: [0, 6, 0] },
    { from: [10, 0, 0], to: [10, 6, 0] },
  ],
  joints: [
    { at: [0, 0, 0], axis: [0, 0, 1] },
    { at: [10, 0, 0], axis: [0, 0, 1] },
  ],
});

async function openMoving(page: Page): Promise<void> {
  await openEmpty(page);
  await openText(page, ARMS);
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 90_000 });
  await page.getByRole('link', { name: 'Move', exact: true }).click();
  await expect(page.getByRole('slider', { name: 'Angle' })).toBeVisible({ timeout: 90_000 });
}

/** Plays until what stands on a slider has changed, then stops it. */
async function playsOn(page: Page, name: string): Promise<void> {
  const angle = page.getByRole('slider', { name });
  const before = await angle.inputValue();
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await expect(angle).not.toHaveValue(before);
  await page.getByRole('button', { name: 'Pause', exact: true }).click();
}

test('two joints move at once', async ({ page }) => {
  await openMoving(page);
  await page.getByRole('checkbox', { name: /Joint 2/ }).check();
  const sliders = page.locator('.motion-player').getByRole('slider');
  await expect(sliders).toHaveCount(2);
  await playsOn(page, 'Angle, Joint 1');
  await expect(page.getByRole('slider', { name: 'Angle, Joint 2' })).not.toHaveValue('0');
  await page.getByRole('checkbox', { name: /Joint 2/ }).uncheck();
  await expect(sliders).toHaveCount(1);
});

const CORNERS = [
  [0, 0, 0],
  [10, 0, 0],
  [0, 6, 0],
  [10, 6, 0],
] as const;

/** Looks from straight above at the drawing alone. @returns where a point of the ground is on screen. */
async function fromAbove(page: Page) {
  await page.getByRole('radio', { name: 'Sketch' }).check({ force: true });
  await page.locator('.scene canvas').focus();
  await page.keyboard.press('t');
  await settled(page);
  await page.getByRole('radio', { name: 'Both' }).check({ force: true });
  await settled(page);
  const box = await steadyBox(page.locator('.scene canvas'));
  const camera = new Camera('top', CORNERS, box);
  return (x: number, y: number) => {
    const [right, up] = camera.at([x, y, 0]);
    return { x: box.x + box.width / 2 + right, y: box.y + box.height / 2 - up };
  };
}

test('an arm that is dragged turns about its joint', async ({ page }) => {
  await openMoving(page);
  await expect(page.getByText('Drag a moving part')).toBeVisible();
  const at = await fromAbove(page);
  const [from, to] = [at(0, 4.5), at(-3.2, 3.2)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2);
  await page.mouse.move(to.x, to.y);
  await page.mouse.up();
  const angle = page.getByRole('slider', { name: 'Angle' });
  await expect.poll(async () => Math.round(Math.abs(Number(await angle.inputValue())))).toBe(45);
});

test('an arm of another joint takes the motion over when it is dragged', async ({ page }) => {
  await openMoving(page);
  await expect(page.getByText('Drag a moving part')).toBeVisible();
  const at = await fromAbove(page);
  // Pressed in a hole, through which one sees the ground.
  const [from, to] = [at(10, 5), at(13.5, 3.5)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const second = page.getByRole('button', { name: 'Joint 2', exact: true });
  await expect(second).toHaveAttribute('aria-pressed', 'true');
  const angle = page.getByRole('slider', { name: 'Angle' });
  await expect(async () => {
    await page.mouse.move(to.x - 1, to.y);
    await page.mouse.move(to.x, to.y);
    expect(Math.round(Math.abs(Number(await angle.inputValue())))).toBe(45);
  }).toPass();
  await page.mouse.up();
});

test('a hole is traced, angles are plotted, table and film are taken along', async ({ page }) => {
  await openMoving(page);
  const at = await fromAbove(page);
  await page.getByRole('button', { name: 'Trace a hole' }).click();
  const hole = at(0, 6);
  await page.mouse.click(hole.x, hole.y);
  await expect(page.getByRole('button', { name: 'Trace no more: Point 1' })).toBeVisible();
  await expect(page.getByRole('img', { name: /^Angles over time: Joint 1 from/ })).toBeVisible();
  const table = await downloaded(page, () => page.getByRole('button', { name: 'Table' }).click());
  const [head = '', ...rows] = table.trim().split('\n');
  expect(head).toContain('Joint 1 (degrees)');
  const columns = head.split(',');
  const values = rows.map((row) => row.split(',').map(Number));
  const column = (name: string) => values.map((row) => row[columns.indexOf(name)] ?? 0);
  const [xs, ys] = [column('Point 1 x'), column('Point 1 y')];
  // The arm's end goes round its joint, and the joint through its whole range.
  for (const [i, x] of xs.entries()) {
    expect(Math.hypot(x, ys[i] ?? 0)).toBeCloseTo(6, 1);
  }
  const angles = column('Joint 1 (degrees)');
  expect(Math.max(...angles) - Math.min(...angles)).toBeGreaterThan(90);
  const seconds = column('seconds').at(-1) ?? 0;
  const waiting = page.waitForEvent('download', { timeout: 100_000 });
  await page.getByRole('button', { name: 'Save as GIF' }).click();
  const gif = await (await waiting).createReadStream();
  const chunks: Buffer[] = [];
  for await (const chunk of gif) {
    chunks.push(chunk as Buffer);
  }
  expect(await countFrames(page, Buffer.concat(chunks))).toBe(Math.ceil(seconds * 10));
});
