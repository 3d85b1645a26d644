// Shafts across a frame, coupled by a typed ratio: the model has the gears, and the check turns them.
import type { Page } from '@playwright/test';
import {
  downloaded,
  expect,
  generate,
  openEmpty,
  openText,
  runCommand,
  savedSketch,
  test,
} from './helpers/test.ts';

const upright = (y: number) => [
  { from: [0, y, 4], to: [14, y, 4] },
  { from: [0, y, 0], to: [14, y, 0] },
  { from: [0, y, 0], to: [0, y, 4] },
  { from: [14, y, 0], to: [14, y, 4] },
];
const FRAME = {
  format: 'technic-sketch',
  version: 2,
  lines: [
    ...upright(0),
    ...upright(4),
    { from: [0, 0, 0], to: [0, 4, 0] },
    { from: [14, 0, 0], to: [14, 4, 0] },
  ],
  shafts: [
    { from: [4, -2, 4], to: [4, 5, 4] },
    { from: [9, -1, 4], to: [9, 6, 4] },
  ],
};

/** The shafts are played, and taken along as a table, in which one turns fifteen times for the other. */
async function turns(page: Page): Promise<void> {
  await page.getByRole('link', { name: 'Move', exact: true }).click();
  const angle = page.getByRole('slider', { name: 'Angle' });
  await expect(angle).toBeVisible({ timeout: 90_000 });
  await expect(page.locator('.motion-list')).toContainText('15 : 1');
  await expect(angle).toHaveValue('0');
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await expect(angle).not.toHaveValue('0');
  await page.getByRole('button', { name: 'Pause', exact: true }).click();
  const table = await downloaded(page, () => page.getByRole('button', { name: 'Table' }).click());
  const [head = '', ...rows] = table.trim().split('\n');
  const columns = head.split(',');
  const last = rows.at(-1)?.split(',').map(Number) ?? [];
  const turnedBy = (shaft: number) =>
    Math.abs(last[columns.indexOf(`Shaft ${shaft} (degrees)`)] ?? 0);
  expect(turnedBy(2)).toBeCloseTo(360, 1);
  expect(turnedBy(1)).toBeCloseTo(15 * 360, 1);
}

test('two shafts are coupled at a typed ratio, and the model is buildable with its gears', async ({
  page,
}) => {
  test.slow();
  await openEmpty(page);
  await openText(page, JSON.stringify(FRAME));
  await expect
    .poll(async () => ((await savedSketch(page)) as { shafts?: unknown[] } | null)?.shafts?.length)
    .toBe(2);
  await runCommand(page, 'Shaft with gears');
  await page.getByLabel('Ratio').fill('15');
  await page.getByRole('button', { name: 'Couple the last two' }).click();
  await expect
    .poll(async () => ((await savedSketch(page)) as unknown as { drives?: unknown }).drives)
    .toEqual([{ from: 0, to: 1, ratio: 15 }]);
  await runCommand(page, 'Crank on the last shaft');
  await page.getByLabel('At its end').selectOption('wheel');
  await expect
    .poll(async () => ((await savedSketch(page)) as { shafts?: unknown[] } | null)?.shafts?.[1])
    .toEqual({ ...FRAME.shafts[1], atFrom: 'crank', atTo: 'wheel' });
  await generate(page);
  await expect(page.getByTestId('verdict')).toContainText('Buildable');
  await turns(page);
  await runCommand(page, 'Remove all shafts and gears');
  await expect
    .poll(async () => Object.keys((await savedSketch(page)) ?? {}))
    .not.toContain('shafts');
});

test('both axles of the wagon in the gallery turn', async ({ page }) => {
  test.slow();
  await page.goto('./?room=gallery');
  await page.locator('[data-model="wagon"]').getByRole('button', { name: 'Move it' }).click();
  const angle = page.getByRole('slider', { name: 'Angle' });
  await expect(angle).toBeVisible({ timeout: 90_000 });
  await page.getByRole('checkbox', { name: /Shaft 2/ }).check();
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  for (const name of ['Angle, Shaft 1', 'Angle, Shaft 2']) {
    await expect(page.getByRole('slider', { name })).not.toHaveValue('0');
  }
  await page.getByRole('button', { name: 'Pause', exact: true }).click();
});
