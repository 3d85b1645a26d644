import { nameIn } from './helpers/links.ts';
import {
  expect,
  expectLines,
  openEmpty,
  openPage,
  openText,
  test,
  withoutDrawing,
} from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

const GOOD = JSON.stringify({
  format: 'technic-sketch',
  version: 1,
  name: 'Opened',
  lines: [
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [8, 0, 0], to: [8, 6, 0] },
    { from: [8, 6, 0], to: [0, 0, 0] },
  ],
});

const line = (from: string, to: string) =>
  `{"format":"technic-sketch","version":1,"lines":[{"from":${from},"to":${to}}]}`;

function hugeFile(): string {
  const row = '{"from":[0,0,0],"to":[8,0,0]},';
  return `{"format":"technic-sketch","version":1,"lines":[${row.repeat(300_000)}]}`;
}

const BAD: readonly (readonly [string, string, RegExp])[] = [
  ['broken.json', '{"format":"technic-sketch","version":1,"lines":[{', /JSON/i],
  ['wrong-types.json', line('[0,0,"a"]', '[8,0,0]'), /lines\[0\]\.from/],
  ['length.json', line('[0,0,0]', '[4.5,0,0]'), /4\.5.*whole number/],
  ['diagonal.json', line('[0,0,0]', '[2,3,6]'), /plane/],
  ['nan.json', line('[0,0,NaN]', '[8,0,0]'), /JSON/i],
  ['empty.json', '', /empty/],
  ['huge.json', hugeFile(), /limit|at most/],
  ['other.json', '{"hello":"world"}', /format/],
];

test('a sketch file is opened, and undo brings back what was there', async ({ page }) => {
  await openEmpty(page);
  await openText(page, GOOD, 'good.sketch.json');
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Opened');
  await expectLines(page, 3);
  await page.keyboard.press('Control+z');
  await expect(page.getByText('Draw some lines first.')).toBeVisible();
});

test('a dropped file is opened', async ({ page }) => {
  await openEmpty(page);
  const data = await page.evaluateHandle((content) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], 'dropped.json', { type: 'application/json' }));
    return transfer;
  }, GOOD);
  await page.dispatchEvent('.stage', 'drop', { dataTransfer: data });
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Opened');
});

for (const [name, content, message] of BAD) {
  test(`one clear message for the bad file ${name}, and the sketch stays`, async ({ page }) => {
    await openEmpty(page);
    await openText(page, GOOD, 'good.sketch.json');
    await expect(page.getByLabel('Name of the sketch')).toHaveValue('Opened');
    await openText(page, content, name);
    const alert = page.getByRole('alert');
    await expect(alert).toContainText(name);
    await expect(alert).toContainText(message);
    await expect(alert).toHaveCount(1);
    await expectLines(page, 3);
  });
}

test('the message of one bad file makes way for that of the next', async ({ page }) => {
  await openEmpty(page);
  for (const [name, content] of BAD.slice(0, 2)) {
    await openText(page, content, name);
    const alert = page.getByRole('alert');
    await expect(alert).toContainText(name);
    await expect(alert).toHaveCount(1);
  }
});

test('the link holds the sketch', async ({ page, context }) => {
  await openEmpty(page);
  await openText(page, GOOD, 'good.sketch.json');
  // The address follows the drawing a moment later.
  await expect.poll(() => nameIn(page.url())).toBe('Opened');
  const address = page.url();

  const other = await context.browser()?.newContext();
  const visitor = await other?.newPage();
  if (!visitor) {
    throw new Error('no second visitor');
  }
  await visitor.addInitScript(withoutDrawing);
  await openPage(visitor, address);
  await expect(visitor.getByLabel('Name of the sketch')).toHaveValue('Opened');
  await other?.close();
});

test('a broken link gives one sentence', async ({ page }) => {
  await openPage(page, '/#s1.garbage.0');
  await expect(page.getByRole('alert')).toContainText('damaged');
});
