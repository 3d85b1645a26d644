import {
  chooseExample,
  clickPlaces,
  expect,
  expectLines,
  openPage,
  runCommand,
  test,
} from './helpers/test.ts';

test.describe('with all that is drawn', () => {
  // Small: without a graphics card each pixel counts.
  test.use({ draws: true, viewport: { width: 900, height: 500 } });

  test('the page starts with an example that is solved, shown, and saved as a picture', async ({
    page,
  }) => {
    // Each pixel of both pictures is drawn by the processor.
    test.setTimeout(240_000);
    await openPage(page);
    await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 60_000 });
    await expect(page.locator('.parts tbody tr').first()).toBeVisible();
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      runCommand(page, 'download picture'),
    ]);
    expect(file.suggestedFilename()).toMatch(/\.png$/);
  });
});

test.use({ draws: false });

test('an example is chosen from the list and solved', async ({ page }) => {
  await openPage(page);
  await chooseExample(page, /^House/);
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('House');
  await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 90_000 });
});

test('a newcomer’s box is a model after a few clicks, and nothing else', async ({ page }) => {
  await openPage(page);
  await page.getByRole('button', { name: 'Draw your own' }).click();
  await expect(page.getByText('It comes by itself')).toBeVisible();
  await page.getByRole('button', { name: 'Box frame' }).click();
  await clickPlaces(page, [
    [-120, 0],
    [120, -40],
    [120, 60],
  ]);
  await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 60_000 });
  await expectLines(page, 12);
});
