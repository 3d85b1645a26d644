// Shafts across a frame, coupled by a typed ratio: the model has the gears, and the check turns them.
import {
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
  await generate(page);
  await expect(page.getByTestId('verdict')).toContainText('Buildable');
  await runCommand(page, 'Remove all shafts and gears');
  await expect
    .poll(async () => Object.keys((await savedSketch(page)) ?? {}))
    .not.toContain('shafts');
});
