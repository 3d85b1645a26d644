import { expect, expectLines, expectSketch, openEmpty, openText, test } from './helpers/test.ts';

test.use({ draws: false });

const OBJ = [
  '# from a modelling program',
  'o Frame',
  'v 0 0 0',
  'v 8 0 0',
  'v 8 6 0',
  'v 0 6 0',
  'l 1 2 3 4 1',
].join('\n');

const MPD = [
  '0 FILE Pair.ldr',
  '0 Pair',
  '1 71 0 0 0 0 0 -1 0 1 0 1 0 0 32316.dat',
  '1 0 0 -10 0 0 1 0 -1 0 0 0 0 1 2780.dat',
  '0 STEP',
  '0 NOFILE',
].join('\r\n');

test('line segments of an .obj file become a sketch', async ({ page }) => {
  await openEmpty(page);
  await openText(page, OBJ, 'frame.obj');
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('frame');
  await expectLines(page, 4);
});

test('an .mpd file is shown and checked', async ({ page }) => {
  await openEmpty(page);
  await openText(page, MPD, 'pair.mpd');
  // The message goes away after a while, whenever the verdict comes.
  await Promise.all([
    expect(page.getByText('Opened the model pair.mpd')).toBeVisible(),
    expect(page.getByTestId('verdict')).toBeVisible(),
  ]);
});

test('a drawing whose lengths are not whole is offered as the nearest that can be built', async ({
  page,
}) => {
  await openEmpty(page);
  await openText(page, OBJ.replaceAll('8', '7.93').replaceAll('6', '6.06'), 'rounded.obj');
  await expect(page.getByRole('alert')).toContainText('7.93');
  await page.getByRole('button', { name: 'Show the nearest that can be built' }).click();
  const sheet = page.getByRole('dialog', { name: 'The nearest drawing that can be built' });
  await expect(sheet).toContainText('4 of 4 lines change');
  await expect(sheet).toContainText('7.93 becomes 8');
  await sheet.getByRole('button', { name: 'Take this one' }).click();
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('rounded');
  await expect(page.getByRole('alert')).toHaveCount(0);
  await expectSketch(page, ({ lines }) => lines.map(({ to }) => to), [
    [8, 0, 0],
    [8, 6, 0],
    [0, 6, 0],
    [0, 0, 0],
  ]);
});

const BAD: readonly (readonly [string, string, RegExp])[] = [
  ['mesh.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', /line 4: a surface/],
  ['short.obj', 'v 0 0 0\nv 0.5 0 0\nl 1 2\n', /lines\[0\]/],
  ['other.mpd', '0 FILE a.ldr\n1 71 0 0 0 1 0 0 0 1 0 0 0 1 3001.dat\n', /3001 \(1\)/],
];

test('bad files give one clear message each', async ({ page }) => {
  await openEmpty(page);
  for (const [name, content, message] of BAD) {
    await openText(page, content, name);
    const alert = page.getByRole('alert');
    await expect(alert).toHaveCount(1);
    await expect(alert).toContainText(name);
    await expect(alert).toContainText(message);
  }
});
