// What axe says of every screen: in both themes and at a phone's width (helpers/axe.ts).
import { expectAccessible } from './helpers/axe.ts';
import { linkOf, publicSketch } from './helpers/links.ts';
import { scaffold } from './helpers/sketches.ts';
import { expect, goTo, openEmpty, openPage, openText, runCommand, test } from './helpers/test.ts';

// Nothing here looks at the picture.
test.use({ draws: false });

test('axe finds nothing serious in the drawing with a model, its panel and its menus', async ({
  page,
}) => {
  await openPage(page);
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
  await page.locator('.panel details').evaluateAll((sections) => {
    for (const section of sections) {
      (section as HTMLDetailsElement).open = true;
    }
  });
  await expectAccessible(page, 'the model');
  for (const flyout of ['Look inside', 'Standard views']) {
    await page.locator(`summary[aria-label^="${flyout}"]`).click();
    await expectAccessible(page, flyout);
    await page.keyboard.press('Escape');
  }
  for (const place of ['Check', 'Move']) {
    await goTo(page, place);
    await expect(page.locator('.panel').getByText('Loading…')).toBeHidden();
    await expectAccessible(page, place);
  }
});

test('axe finds nothing serious on any sheet', async ({ page }) => {
  await openPage(page);
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
  for (const [words, name] of [
    ['menu', 'Menu'],
    ['all commands', 'All commands'],
    ['keys help', 'Keys and help'],
    ['examples', 'Examples'],
    ['my sketches', 'My sketches'],
    ['brick set', 'Brick set'],
    ['about', 'About Liftarm'],
  ] as const) {
    await runCommand(page, words);
    await expect(page.getByRole('dialog', { name })).toBeVisible();
    await expectAccessible(page, name);
    await page.keyboard.press('Escape');
    await expect(page.getByRole('dialog')).toBeHidden();
  }
});

test('axe finds nothing serious while a search runs, and when it fails', async ({ page }) => {
  await openEmpty(page);
  await expectAccessible(page, 'the empty page');
  await openText(page, scaffold(14));
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByText(/\d steps/)).toBeVisible({ timeout: 60_000 });
  await expectAccessible(page, 'a running search');
  await page.getByRole('button', { name: /^Cancel/ }).click();
  await expectAccessible(page, 'a search that was stopped');
  // Two lines cross between their nodes: no pin can join them there.
  const lines = [
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [3.5, -4, 0], to: [3.5, 4, 0] },
  ];
  const sketch = { format: 'technic-sketch', version: 1, name: 'Crossing', lines };
  await openText(page, JSON.stringify(sketch));
  await expect(page.getByLabel('Name of the sketch')).toHaveValue('Crossing');
  await page.getByRole('button', { name: /^Generate/ }).click();
  await expect(page.getByTestId('verdict')).toBeVisible({ timeout: 60_000 });
  await expectAccessible(page, 'a model that cannot be built');
  await openText(page, '{"format": "technic-sketch", "version": 1, "lines": [{}]}');
  await expect(page.getByRole('alert')).toBeVisible();
  await expectAccessible(page, 'a file that is refused');
});

test('axe finds nothing serious in the rooms of a model', async ({ page }) => {
  await page.goto(`./?room=instructions${await linkOf(publicSketch('examples/square-frame'))}`);
  await expect(page.getByText('Loading…')).toBeHidden();
  for (const tab of ['Steps', 'Parts', 'Film']) {
    await page.getByRole('radio', { name: tab, exact: true }).check({ force: true });
    await expectAccessible(page, `instructions, ${tab}`);
  }
  await page.getByRole('button', { name: 'Back to the drawing' }).click();
  await expect(page.locator('.room')).toBeHidden();
  await runCommand(page, 'share and download');
  await expect(page.locator('.room-body > *').first()).toBeVisible();
  await expect(page.getByText('Loading…')).toBeHidden();
  await expectAccessible(page, 'share');
});

test('axe finds nothing serious in the gallery, in the lessons and on the teacher’s page', async ({
  page,
}) => {
  await page.goto('./?room=gallery');
  await expect(page.locator('.gallery-card').first()).toBeVisible();
  await expectAccessible(page, 'gallery');
  await page.goto('./?room=lessons');
  await expect(page.locator('.lesson-card').first()).toBeVisible();
  await expectAccessible(page, 'lessons');
  const cards = await page.locator('.lesson-card').count();
  await page.locator('.lesson-card').first().click();
  for (let i = 0; i < cards; i++) {
    const lesson = page.locator('[data-lesson]');
    await expect(lesson.locator('svg').first()).toBeVisible();
    await expectAccessible(page, `lesson ${await lesson.getAttribute('data-lesson')}`);
    if (i + 1 < cards) {
      await page.getByRole('button', { name: /^Next/ }).click();
    }
  }
  await page.getByRole('button', { name: 'Teacher’s page' }).click();
  await expectAccessible(page, 'the teacher’s page');
});

test('axe finds nothing serious in the viewer for other pages', async ({ page }) => {
  await page.goto(`./embed.html${await linkOf(publicSketch('examples/square-frame'))}`);
  await expect(page.locator('.embed-status')).toHaveAttribute('data-bricks', '8', {
    timeout: 90_000,
  });
  await expectAccessible(page, 'the viewer');
});

test('the page speaks German to those who ask for it', async ({ page }) => {
  await page.goto('/?lang=de#s2.broken.0');
  await expect(page.getByRole('button', { name: 'Rückgängig' })).toBeVisible();
  await expect(page.locator('html')).toHaveAttribute('lang', 'de');
  await expect(page.getByRole('alert')).toContainText('Dieser Link ist beschädigt');
  await page.getByRole('link', { name: 'Prüfen' }).click();
  await expect(page.getByText('Jedes Teil gibt es')).toBeVisible({ timeout: 60_000 });
  await page.keyboard.press('Control+k');
  await page.locator('.palette-input').fill('sprache english');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('button', { name: 'Undo' })).toBeVisible();
});
