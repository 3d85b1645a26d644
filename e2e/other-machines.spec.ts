// The page as another machine of the network gets it: over http, under a name that is no secure context.
import { linkOf, publicSketch } from './helpers/links.ts';
import { expect, test } from './helpers/test.ts';

const HOST = 'liftarm.test';

test.use({
  draws: false,
  launchOptions: async ({ launchOptions }, use) => {
    const rule = `--host-resolver-rules=MAP ${HOST} 127.0.0.1`;
    await use({ ...launchOptions, args: [...(launchOptions.args ?? []), rule] });
  },
});

test('without a secure context the page shows a model, keeps sketches, and makes links', async ({
  page,
  baseURL,
}) => {
  const address = (baseURL ?? '').replace('127.0.0.1', HOST);
  await page.goto(address);
  expect(await page.evaluate(() => isSecureContext)).toBe(false);
  await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 90_000 });
  await page.getByLabel('Name of the sketch').fill('Over the network');
  await page.getByLabel('Name of the sketch').press('Enter');
  await expect(page.locator('html')).toHaveAttribute('data-kept', 'kept');
  await expect(page).toHaveURL(/#s\d+\./);
  await page.reload();
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Over the network');
  await page.goto(`${address}${await linkOf({ ...publicSketch('gallery/claw'), name: 'Linked' })}`);
  await page.reload();
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Linked');
  await page.goto(`${address}?room=share`);
  await page.getByRole('button', { name: 'Copy the link' }).click();
  await expect(page.getByText(/^Copied/)).toBeVisible();
});
