import { linkOf, publicSketch } from './helpers/links.ts';
import { chooseExample, downloaded, expect, openPage, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

test('after an edit the model goes on from the one before, and says so', async ({ page }) => {
  await openPage(page, `/${await linkOf(publicSketch('examples/house'))}`);
  await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 60_000 });
  await expect(page.getByTestId('grown')).toHaveCount(0);
  const model = () =>
    downloaded(page, () => page.getByRole('button', { name: 'Model', exact: true }).click());
  const placed = (json: string) =>
    (JSON.parse(json) as { parts: { part: string; position: number[] }[] }).parts.map(
      ({ part, position }) => `${part} ${position.join(' ')}`,
    );
  const before = new Set(placed(await model()));
  // A line more, from the keyboard's cursor at the last line's end, upwards.
  await page.locator('.scene canvas').focus();
  await page.keyboard.press('l');
  await page.keyboard.press('Enter');
  for (let i = 0; i < 4; i++) {
    await page.keyboard.press('PageUp');
  }
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  await expect(page.getByTestId('grown')).toBeVisible({ timeout: 60_000 });
  await expect(page.getByTestId('verdict')).toContainText('Buildable');
  const after = placed(await model());
  expect(after.filter((part) => before.has(part)).length).toBeGreaterThan(0.7 * before.size);
  // What a person asks for is what the link gives.
  await page.getByRole('button', { name: 'Generate again' }).click();
  await expect(page.getByTestId('grown')).toHaveCount(0, { timeout: 60_000 });
  await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 60_000 });
});

test('an example that is opened is the model that its link gives', async ({ page }) => {
  await openPage(page);
  await chooseExample(page, /^Truss bridge/);
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Truss bridge');
  await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 60_000 });
  // Longer than the pause after which an edit is solved.
  await page.waitForTimeout(1500);
  await expect(page.getByRole('progressbar')).toHaveCount(0, { timeout: 60_000 });
  await expect(page.getByTestId('grown')).toHaveCount(0);
});
