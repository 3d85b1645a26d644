import { mutate, random } from '../tests/web/helpers/mutate-link.ts';
import { linkOf, publicSketch } from './helpers/links.ts';
import { expect, openEmpty, openPage, openText, savedSketch, test } from './helpers/test.ts';

test.use({ draws: false });

/** `npm run links -- --count 3000` makes more of them. */
const COUNT = Number(process.env['LIFTARM_LINKS'] ?? 60);

test('a link that is pasted into the address of the open page opens', async ({ page }) => {
  await openPage(page);
  const name = page.getByLabel('Name of the sketch');
  const claw = await linkOf({ ...publicSketch('gallery/claw'), name: 'Pasted' });
  await page.evaluate((hash) => {
    location.hash = hash;
  }, claw);
  await expect(name).toHaveValue('Pasted');
  // A broken one gives a sentence; the sketch stays, and so does the address that holds it.
  await page.evaluate(() => {
    location.hash = '#s2.broken.0';
  });
  await expect(page.getByRole('alert')).toContainText('damaged');
  await expect(name).toHaveValue('Pasted');
  await expect(page).not.toHaveURL(/broken/);
});

test('a link that is pasted while the page starts is opened too', async ({ page }) => {
  const claw = await linkOf({ ...publicSketch('gallery/claw'), name: 'Pasted' });
  await page.addInitScript((hash) => {
    document.addEventListener('DOMContentLoaded', () => {
      if (location.hash === '') {
        location.hash = hash;
      }
    });
  }, claw);
  await openPage(page);
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Pasted');
});

test(`${COUNT} mutated links do the open page no harm`, async ({ page }) => {
  test.setTimeout(120_000 + COUNT * 1500); // as long as it takes: the count is what is tested
  await openEmpty(page);
  await openText(page, JSON.stringify({ ...publicSketch('gallery/claw'), name: 'Kept' }));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Kept');
  const next = random(7);
  const whole = (await linkOf(publicSketch('examples/seesaw'))).slice(1);
  const links = Array.from({ length: COUNT }, () => mutate(whole, next));
  const refused = await page.evaluate(async (all) => {
    let alerts = 0;
    for (const link of all) {
      location.hash = `#${link}`;
      // The page says what is wrong or shows the sketch, and then puts its own address there again.
      for (let tries = 0; tries < 400 && history.state?.liftarm !== 'own'; tries++) {
        await new Promise((done) => setTimeout(done, 5));
      }
      if (history.state?.liftarm !== 'own') {
        throw new Error(`no answer to ${link}`);
      }
      alerts += document.querySelector('[role="alert"]') ? 1 : 0;
    }
    return alerts;
  }, links);
  expect(refused).toBeGreaterThan(COUNT / 2);
  await expect(page.locator('script:not([src])')).toHaveCount(0);
  await expect.poll(async () => (await savedSketch(page)).lines.length).toBeGreaterThan(0);
  await page.keyboard.press('Control+z');
});
