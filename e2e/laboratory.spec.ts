// Methods race in workers, bricks are taken away, weights are turned; each with a way to stop it.
import type { Page } from '@playwright/test';
import { encodeShare } from '../web/src/share/codec.ts';
import { linkOf, publicSketch } from './helpers/links.ts';
import { expect, savedSketch, test, textOf } from './helpers/test.ts';

test.use({ draws: false });

const SMALL = 'grid-1.grid-2~default.greedy~1~short~paper';

/** Straight beams of 7 holes and more. */
const LONG = ['32524', '40490', '32525', '41239', '32278'];

const status = (page: Page) => page.getByTestId('race-status');

async function openRace(page: Page, race: string, fragment = ''): Promise<void> {
  await page.goto(`./?room=laboratory&race=${race}${fragment}`);
  await expect(page.getByRole('button', { name: 'Start the race' })).toBeVisible();
}

async function finishRace(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Start the race' }).press('Enter');
  await expect(status(page)).toContainText('The race is over', { timeout: 120_000 });
}

/** The saved table without what depends on the machine: seconds come last. */
async function csvOf(page: Page): Promise<string[]> {
  const waiting = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save as CSV' }).click();
  const rows = (await textOf(await waiting)).trim().split('\n');
  return rows.map((row) => row.replace(/,[^,]*$/, ''));
}

test('a race runs to its end, and its link gives the same results', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await openRace(page, SMALL);
  await finishRace(page);
  await expect(page.locator('.lab-card[data-phase="done"]')).toHaveCount(4);
  await expect(page.locator('.lab-card canvas')).toHaveCount(4);
  await expect(page.getByRole('img', { name: /^beams over the seconds/ })).toBeVisible();
  await expect(page.getByRole('img', { name: /^seconds by the length/ })).toBeVisible();
  const first = await csvOf(page);
  expect(first).toHaveLength(5);
  await page.getByRole('button', { name: 'Copy a link to this race' }).click();
  await expect(page.getByText('The link is copied.')).toBeVisible();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  await page.goto('about:blank');
  await page.goto(link);
  await finishRace(page);
  expect(await csvOf(page)).toEqual(first);
});

test('what is chosen stands in the address, and nothing chosen cannot start', async ({ page }) => {
  await openRace(page, 'grid-1~default~1~short~paper');
  await expect(status(page)).toHaveText('Searches to make: 1');
  await page.getByRole('checkbox', { name: 'Random' }).check();
  await page.getByRole('checkbox', { name: 'Cube of 8' }).check();
  await expect(page).toHaveURL(
    /race=grid-1\.cube-8%7Edefault\.random%7E|race=grid-1\.cube-8~default\.random~/,
  );
  for (const name of ['Grid 1 × 1', 'Cube of 8']) {
    await page.getByRole('checkbox', { name }).uncheck();
  }
  await expect(status(page)).toHaveText('Choose a drawing and a method.');
  await expect(page.getByRole('button', { name: 'Start the race' })).toBeDisabled();
});

test('a race that takes long is stopped at once', async ({ page }) => {
  await openRace(page, 'grid-10~paper.random.ant-colony~1~whole~ours');
  await page.getByRole('button', { name: 'Start the race' }).click();
  await expect(page.locator('.lab-card[data-phase="running"]').first()).toBeVisible();
  await page.getByRole('button', { name: 'Stop' }).click();
  await expect(page.locator('.lab-card[data-phase="stopped"]')).toHaveCount(3);
  await expect(page.getByRole('button', { name: 'Start the race' })).toBeEnabled();
});

test('a kind of beam is taken away, and the model does without it', async ({ page }) => {
  await page.goto('./?room=laboratory&lab=bricks');
  await page.getByRole('combobox', { name: 'Drawing' }).selectOption('grid-1');
  await page.getByRole('button', { name: 'Make the model' }).click();
  const cards = page.locator('.lab-card');
  const uses = cards.first().locator('.lab-uses button');
  await expect(uses.first()).toBeEnabled({ timeout: 60_000 });
  const taken = ((await uses.first().getAttribute('aria-label')) ?? '').replace('Take away: ', '');
  await uses.first().click();
  await expect(cards).toHaveCount(2, { timeout: 60_000 });
  await expect(cards.nth(1)).toContainText(`Without ${taken} as well`);
  await expect(cards.nth(1).locator('.lab-uses')).not.toContainText(taken);
});

test('four proposals for the drawing; one is taken with its weights', async ({ page }) => {
  const fragment = await linkOf(publicSketch('examples/square-frame'));
  await page.goto(`./?room=laboratory&lab=weights${fragment}`);
  await page.getByRole('slider', { name: 'Few beams' }).fill('1');
  await page.getByRole('button', { name: 'Make four proposals' }).click();
  const stiff = page.getByRole('button', { name: /^Stiff/ });
  await expect(stiff).toBeEnabled({ timeout: 120_000 });
  await expect(page.locator('.alternative:enabled')).toHaveCount(4, { timeout: 120_000 });
  await stiff.click();
  await expect(page.getByTestId('verdict')).toContainText('Buildable', { timeout: 60_000 });
  await expect(page.getByRole('link', { name: 'Draw' })).toHaveAttribute('aria-current', 'page');
});

test('proposals need a drawing, and say so', async ({ page }) => {
  const empty = { format: 'technic-sketch', version: 1, name: '', lines: [] } as const;
  await page.goto(`./?room=laboratory&lab=weights${await linkOf(empty as never)}`);
  await expect(page.getByText('There is no model here yet.')).toBeVisible();
});

/** The link of a pupil who builds the drawing with some kinds of beams switched off. */
async function pupilsLink(seed: number, off: readonly string[]): Promise<string> {
  const sketch = publicSketch('examples/square-frame');
  const settings = { effort: 1, off, owned: {}, advanced: '' };
  const fragment = await encodeShare({ sketch, preset: 'simple', seed, settings });
  return fragment.ok ? `https://liftarm.example/#${fragment.value}` : '';
}

test('a class of thirty is judged again: a wrong score and a broken link show', async ({
  page,
}) => {
  const drawing = publicSketch('examples/square-frame');
  const whole = await pupilsLink(1, []);
  const rows: string[] = [];
  for (let i = 1; i <= 26; i++) {
    rows.push(`Pupil ${i} ${await pupilsLink(i, [])} 4`);
  }
  // No beam is as long as a side, so it takes more.
  rows.push(`Short ${await pupilsLink(1, LONG)}`);
  rows.push(`Boaster ${whole} 3`);
  rows.push(`Broken ${whole.slice(0, -2)} 4`);
  rows.push(`Other https://liftarm.example/${await linkOf(publicSketch('examples/chair'))} 4`);
  await page.goto(`./?room=laboratory&lab=contest${await linkOf(drawing)}`);
  const entries = page.getByRole('textbox', { name: 'Entries' });
  await entries.fill(rows.join('\n'));
  const status = page.getByTestId('contest-status');
  await expect(status).toHaveText('Entries: 30');
  await page.getByRole('button', { name: 'Judge all' }).click();
  await expect(status).toHaveText('Judged: 30', { timeout: 110_000 });
  const table = page.locator('.ranking tbody tr');
  await expect(table).toHaveCount(30);
  const row = (name: string) => table.filter({ has: page.getByRole('rowheader', { name }) });
  await expect(table.first().locator('td').first()).toHaveText('1');
  await expect(row('Boaster')).toContainText('Says 3, has 4');
  await expect(row('Broken')).toContainText('The link is broken');
  await expect(row('Other')).toContainText('Another drawing');
  await expect(row('Short').locator('td').first()).toHaveText('28');
  await expect(page.locator('.ranking [data-wrong]')).toHaveCount(3);
});

test('a bridge that folds under the truck has no price', async ({ page }) => {
  await page.goto('./?room=laboratory&lab=contest');
  await page.getByRole('radio', { name: 'Cheapest bridge' }).check({ force: true });
  await page.getByRole('spinbutton', { name: 'x of the deck’s end' }).fill('8');
  await page.getByRole('textbox', { name: 'Entries' }).fill(`Ann ${await pupilsLink(1, [])} 12`);
  await page.getByRole('button', { name: 'Judge all' }).click();
  await expect(page.getByTestId('contest-status')).toHaveText('Judged: 1', { timeout: 60_000 });
  await expect(page.locator('.ranking tbody tr')).toContainText('has no score');
});

test('the lightest truss under a deck is shown, and becomes the drawing', async ({ page }) => {
  await page.goto('./?room=laboratory&lab=contest');
  await page.getByRole('radio', { name: 'Cheapest bridge' }).check({ force: true });
  await page.getByRole('spinbutton', { name: 'x of the deck’s end' }).fill('16');
  await page.getByRole('button', { name: 'Show the lightest truss' }).click();
  await expect(page.getByRole('img', { name: /^The lightest flat truss/ })).toBeVisible({
    timeout: 100_000,
  });
  await page.getByRole('button', { name: 'Make it the drawing' }).click();
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Lightest truss');
  expect((await savedSketch(page)).lines.length).toBeGreaterThan(20);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 } });

  for (const tab of ['race', 'bricks', 'weights', 'contest']) {
    test(`nothing of the part ${tab} is wider than the page, in German`, async ({ page }) => {
      await page.goto(`./?lang=de&room=laboratory&lab=${tab}`);
      await expect(page.getByRole('radio', { name: 'Wettbewerb' })).toBeAttached();
      const wide = await page
        .locator('.room-body')
        .evaluate((body) => body.scrollWidth - body.clientWidth);
      expect(wide).toBeLessThanOrEqual(0);
    });
  }

  test('nothing of the laboratory is wider than the page', async ({ page }) => {
    await openRace(page, 'grid-1~default.greedy~1~short~paper');
    await finishRace(page);
    const wide = await page
      .locator('.room-body')
      .evaluate((body) => body.scrollWidth - body.clientWidth);
    expect(wide).toBeLessThanOrEqual(0);
  });
});
