// Several models of one drawing, and models of the parts that there are.
import { linkOf, publicSketch } from './helpers/links.ts';
import { expect, openPage, runCommand, test, withoutDrawing } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

test('other models of a drawing are compared, and a click puts one on the page', async ({
  page,
  browser,
}) => {
  await openPage(page, `/${await linkOf(publicSketch('examples/house'))}`);
  await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 60_000 });
  const opened = page.url();
  await page.getByRole('button', { name: 'Other models of this drawing' }).click();
  const sheet = page.getByRole('dialog', { name: 'Other models of this drawing' });
  await expect(sheet.getByText(/^Searched: \d other models\.$/)).toBeVisible({ timeout: 90_000 });
  const cards = sheet.locator('.alternative');
  // Said once all of them are there: as many as are said, and the one on the page.
  const said = await sheet.getByText(/^Searched: \d other models\.$/).textContent();
  const count = 1 + Number.parseInt(said?.replace(/\D/g, '') ?? '0', 10);
  expect(count).toBeGreaterThanOrEqual(3);
  expect(count).toBeLessThanOrEqual(7);
  await expect(cards).toHaveCount(count);
  // The one on the page is there to compare with, not to take.
  await expect(cards.first()).toBeDisabled();
  const rows = sheet.locator('.compare tbody tr');
  await expect(rows).toHaveCount(count);
  const bricks = await rows.nth(1).locator('td').first().textContent();
  await cards.nth(1).click();
  await expect(sheet).toBeHidden();
  await expect(page.getByTestId('verdict')).toContainText('Buildable');
  await expect(page.locator('.figures').getByText(bricks ?? 'none', { exact: true })).toBeVisible();
  // The address holds what it was searched with: somebody else's browser finds the same.
  await expect.poll(() => page.url()).not.toBe(opened);
  const address = page.url();
  const other = await browser.newContext();
  const visitor = await other.newPage();
  await visitor.addInitScript(withoutDrawing);
  await openPage(visitor, address);
  await expect(visitor.getByTestId('verdict')).toContainText('Buildable', { timeout: 60_000 });
  const figures = visitor.locator('.figures');
  await expect(figures.getByText(bricks ?? 'none', { exact: true })).toBeVisible();
  await other.close();
});

test('a model is searched for again when there are fewer parts, without a click', async ({
  page,
}) => {
  await openPage(page, `/${await linkOf(publicSketch('examples/square-frame'))}`);
  const verdict = page.getByTestId('verdict');
  await expect(verdict).toContainText('Buildable', { timeout: 60_000 });
  const long = page.locator('.parts tr').filter({ hasText: '40490' });
  await expect(long.locator('.count')).toHaveText('4×');
  await runCommand(page, 'brick set');
  await page.locator('.brick-card').filter({ hasText: '40490' }).getByRole('spinbutton').fill('2');
  await page.keyboard.press('Escape');
  const count = async () =>
    Number.parseInt((await long.locator('.count').allTextContents())[0] ?? '0', 10);
  await expect.poll(count, { timeout: 60_000 }).toBeLessThanOrEqual(2);
  await expect(verdict).toContainText('Buildable');
  await expect(page.locator('.short')).toHaveCount(0);
});
