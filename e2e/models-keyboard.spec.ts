// The same four models without a pointer.
import type { Page } from '@playwright/test';
import { expect, openEmpty, runCommand, savedSketch, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

async function press(page: Page, keys: string): Promise<void> {
  for (const step of keys.trim().split(/\s+/)) {
    const [key = '', times = '1'] = step.split('*');
    for (let i = 0; i < Number(times); i++) {
      await page.keyboard.press(key);
    }
  }
}

async function begin(page: Page): Promise<void> {
  await openEmpty(page);
  await page.locator('.scene canvas').focus();
}

async function lengths(page: Page): Promise<number[]> {
  const { lines } = (await savedSketch(page)) as { lines: { from: number[]; to: number[] }[] };
  return lines.map(({ from, to }) => Math.hypot(...from.map((v, k) => v - (to[k] ?? 0))));
}

test('table and seesaw with the keyboard alone', async ({ page }) => {
  await begin(page);
  await press(page, 'r Enter ArrowRight*8 ArrowUp*4 Enter');
  await press(page, 'l Enter z 5 Enter Escape');
  await press(page, 'PageDown*5 ArrowRight*8 Enter PageUp*5 Enter Escape');
  await press(page, 'PageDown*5 ArrowUp*4 Enter PageUp*5 Enter Escape');
  await press(page, 'PageDown*5 ArrowLeft*8 Enter PageUp*5 Enter Escape');
  expect(await lengths(page)).toEqual([8, 4, 8, 4, 5, 5, 5, 5]);

  await runCommand(page, 'new sketch');
  await press(page, 'l Enter ArrowRight*8 Enter Escape');
  await press(page, 'ArrowLeft*4 Enter PageUp*5 Enter Escape');
  await press(page, 'ArrowLeft*6 Enter ArrowRight*12 Enter Escape Escape');
  expect(await lengths(page)).toEqual([8, 5, 12]);
  await press(page, 'j ArrowRight*2 Enter');
  const { joints } = (await savedSketch(page)) as { joints?: { at: number[] }[] };
  expect(joints?.map((joint) => joint.at)).toEqual([[4, 0, 5]]);
});

test('house and airplane with the keyboard alone', async ({ page }) => {
  await begin(page);
  await press(page, 'b Enter ArrowRight*6 ArrowUp*6 Enter PageUp*4 Enter');
  expect(await lengths(page)).toHaveLength(12);
  await press(page, 'l Enter');
  await press(page, 'Escape');
  await press(page, 'PageUp*4');
  await press(page, 'Enter ArrowRight*3 PageUp*4 Enter ArrowRight*3 PageDown*4 Enter Escape');
  expect((await lengths(page)).slice(12)).toEqual([5, 5]);

  await runCommand(page, 'new sketch');
  await press(page, 'l Enter ArrowUp*10 Enter Escape');
  await press(page, 'ArrowDown*2 Enter ArrowRight*6 Enter ArrowDown*2 Enter ArrowLeft*6 Enter');
  await press(page, 'Escape Escape');
  // One line of the wing, then its chain, then the mirror at the hull.
  await press(page, 'v .*2 Shift+C m');
  expect(await lengths(page)).toHaveLength(7);
  await press(page, 'Control+z Control+Shift+z');
  expect(await lengths(page)).toHaveLength(7);
});
