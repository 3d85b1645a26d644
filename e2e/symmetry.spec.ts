import type { Page } from '@playwright/test';
import {
  downloaded,
  expect,
  expectSketch,
  generate,
  openEmpty,
  openText,
  type Saved,
  settled,
  test,
} from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

/** Two like ladders beside each other: mirrors, and one shifted is the other. */
const LADDERS = {
  format: 'technic-sketch',
  version: 1,
  lines: [0, 6].flatMap((x) => [
    { from: [x, 0, 0], to: [x, 8, 0] },
    { from: [x, 0, 0], to: [x, 0, 4] },
  ]),
};

test('a shift that the program has found is kept by a click', async ({ page }) => {
  await openEmpty(page);
  await openText(page, JSON.stringify(LADDERS));
  await page.getByRole('heading', { name: 'Symmetry' }).click();
  const shift = page.getByRole('checkbox', { name: /^2 lines again, shifted by \(6, 0, 0\)/ });
  await shift.click();
  const kinds = ({ symmetries }: Saved) => symmetries?.map(({ kind }) => kind) ?? null;
  await expectSketch(page, kinds, ['translation']);
  // Another click lets it go.
  await shift.click();
  await expectSketch(page, kinds, null);
});

/** Two rafters that meet in their mirror: one layer cannot hold both, so the sides must differ. */
const RAFTERS = {
  format: 'technic-sketch',
  version: 1,
  lines: [
    { from: [-8, 0, 0], to: [0, 0, 6] },
    { from: [8, 0, 0], to: [0, 0, 6] },
    { from: [-8, 0, 0], to: [8, 0, 0] },
  ],
};

test('a mirror that parts cannot keep is said to differ, and where', async ({ page }) => {
  await openEmpty(page);
  await openText(page, JSON.stringify(RAFTERS));
  await page.getByRole('heading', { name: 'Symmetry' }).click();
  await page.getByRole('checkbox', { name: 'Mirror at x = 0' }).click();
  await generate(page);
  const differences = page.getByTestId('differences').getByRole('button');
  await expect(differences).toHaveCount(2);
  await expect(differences.first()).toHaveText(/\(-8, 0, 0\) – \(0, 0, 6\)/);
});

/** A box with a mast off its middle: mirrors through the box, of which the mast leaves one. */
const BOX = {
  format: 'technic-sketch',
  version: 1,
  lines: [
    ...[0, 6].flatMap((x) => [0, 8].map((y) => ({ from: [x, y, 0], to: [x, y, 5] }))),
    ...[0, 5].flatMap((z) => [0, 8].map((y) => ({ from: [0, y, z], to: [6, y, z] }))),
    ...[0, 5].flatMap((z) => [0, 6].map((x) => ({ from: [x, 0, z], to: [x, 8, z] }))),
  ],
};

/** Counts what each frame draws from now on. */
async function countDrawn(page: Page): Promise<void> {
  await page.evaluate(() => {
    const counts: number[] = [];
    Object.assign(window, { counts });
    let calls = 0;
    const gl = WebGL2RenderingContext.prototype;
    for (const name of ['drawArrays', 'drawElements'] as const) {
      gl[name] = () => {
        calls += 1;
      };
    }
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (callback) =>
      request((now) => {
        calls = 0;
        callback(now);
        if (calls > 0) {
          counts.push(calls);
        }
      });
  });
}

const drawnNow = (page: Page) =>
  page.evaluate(() => (window as unknown as { counts: number[] }).counts.at(-1) ?? 0);

/** Whether each beam has another (or is one itself) where a mirror puts it. */
function isMirrored(model: string, k: 0 | 1 | 2, twice: number): boolean {
  const { parts } = JSON.parse(model) as {
    parts: { part: string; layer: number; component: number; position: number[] }[];
  };
  const beams = parts.filter(({ component }) => component >= 0);
  const key = (part: string, at: readonly number[]) =>
    `${part} ${at.map((x) => (Math.round(x * 100) / 100 + 0).toFixed(2)).join(' ')}`;
  const known = new Set(beams.map(({ part, position }) => key(part, position)));
  return beams.every(({ part, position }) => {
    const image = position.map((x, i) => (i === k ? twice - x : x));
    return known.has(key(part, image));
  });
}

test('a mirror is shown when pointed at, kept by a click, and found again in the model', async ({
  page,
}) => {
  await openEmpty(page);
  await openText(page, JSON.stringify(BOX));
  await page.getByRole('heading', { name: 'Symmetry' }).click();
  const mirror = page.getByRole('checkbox', { name: 'Mirror at x = 3' });
  await expect(mirror).toBeVisible();
  await countDrawn(page);
  await page.mouse.move(5, 400);
  await page.keyboard.press('f');
  await settled(page);
  const before = await drawnNow(page);
  // The plane and its frame.
  await mirror.hover();
  await expect.poll(() => drawnNow(page)).toBe(before + 3);
  await page.mouse.move(5, 400);
  await expect.poll(() => drawnNow(page)).toBe(before);
  await mirror.click();
  await page.mouse.move(5, 400);
  await expect.poll(() => drawnNow(page)).toBe(before + 3);
  await expectSketch(page, ({ symmetries }) => symmetries ?? [], [
    { kind: 'reflection', normal: [1, 0, 0], offset: 3 },
  ]);
  await generate(page);
  await expect(page.getByTestId('verdict')).toContainText('Buildable');
  await expect(page.getByTestId('differences')).toHaveCount(0);
  const model = await downloaded(page, () =>
    page.getByRole('button', { name: 'Model', exact: true }).click(),
  );
  expect(isMirrored(model, 0, 6)).toBe(true);
});

test('a mirror that the rest of the sketch breaks is offered for its lines alone', async ({
  page,
}) => {
  await openEmpty(page);
  const lines = [...BOX.lines, { from: [6, 8, 5], to: [6, 8, 12] }];
  await openText(page, JSON.stringify({ ...BOX, lines }));
  await page.getByRole('heading', { name: 'Symmetry' }).click();
  const part = page.getByRole('checkbox', { name: '12 lines mirrored at x = 3' });
  await part.click();
  const bound = ({ symmetries }: Saved) => symmetries?.map(({ lines }) => lines?.length) ?? null;
  await expectSketch(page, bound, [12]);
  await page.keyboard.press('Control+z');
  await expectSketch(page, bound, null);
});
