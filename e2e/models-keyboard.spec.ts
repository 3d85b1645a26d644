// The same four models without a pointer.
import type { Page } from '@playwright/test';
import {
  expectLines,
  expectSketch,
  openEmpty,
  runCommand,
  type Saved,
  test,
} from './helpers/test.ts';

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

const lengths = ({ lines }: Saved) =>
  lines.map(({ from, to }) => Math.hypot(...from.map((v, k) => v - (to[k] ?? 0))));

test('table and seesaw with the keyboard alone', async ({ page }) => {
  await begin(page);
  await press(page, 'r Enter ArrowRight*8 ArrowUp*4 Enter');
  await press(page, 'l Enter z 5 Enter Escape');
  await press(page, 'PageDown*5 ArrowRight*8 Enter PageUp*5 Enter Escape');
  await press(page, 'PageDown*5 ArrowUp*4 Enter PageUp*5 Enter Escape');
  await press(page, 'PageDown*5 ArrowLeft*8 Enter PageUp*5 Enter Escape');
  await expectSketch(page, lengths, [8, 4, 8, 4, 5, 5, 5, 5]);

  await runCommand(page, 'new sketch');
  await press(page, 'l Enter ArrowRight*8 Enter Escape');
  await press(page, 'ArrowLeft*4 Enter PageUp*5 Enter Escape');
  await press(page, 'ArrowLeft*6 Enter ArrowRight*12 Enter Escape Escape');
  await expectSketch(page, lengths, [8, 5, 12]);
  await press(page, 'j ArrowRight*2 Enter');
  await expectSketch(page, ({ joints }) => joints?.map((joint) => joint.at), [[4, 0, 5]]);
});

test('house and airplane with the keyboard alone', async ({ page }) => {
  await begin(page);
  await press(page, 'b Enter ArrowRight*6 ArrowUp*6 Enter PageUp*4 Enter');
  await expectLines(page, 12);
  await press(page, 'l Enter');
  await press(page, 'Escape');
  await press(page, 'PageUp*4');
  await press(page, 'Enter ArrowRight*3 PageUp*4 Enter ArrowRight*3 PageDown*4 Enter Escape');
  await expectSketch(page, (sketch) => lengths(sketch).slice(12), [5, 5]);

  await runCommand(page, 'new sketch');
  await press(page, 'l Enter ArrowUp*10 Enter Escape');
  await press(page, 'ArrowDown*2 Enter ArrowRight*6 Enter ArrowDown*2 Enter ArrowLeft*6 Enter');
  await press(page, 'Escape Escape');
  // One line of the wing, then its chain, then the mirror at the hull.
  await press(page, 'v .*2 Shift+C m');
  await expectLines(page, 7);
  await press(page, 'Control+z Control+Shift+z');
  await expectLines(page, 7);
});
